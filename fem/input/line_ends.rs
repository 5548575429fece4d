//! Names of files that would make lines of their own wherever they are shown.

use super::Problem;
use super::visible::on_one_line;

/// Refuses the name of a file that would make lines of its own wherever it is shown.
///
/// # Errors
/// There is a line end in it.
pub fn one_line(name: &str) -> Result<(), Problem> {
    match name.contains(['\n', '\r']) {
        false => Ok(()),
        true => {
            let problem = Problem::new(format!("there is a line end in the name `{}`", on_one_line(name)));
            Err(problem.help("rename the file: its name is shown as a part of a line"))
        }
    }
}
