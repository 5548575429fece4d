//! Files of tables that take known quantities alone and may name models: budgets, plans of studies.

use std::cell::RefCell;

use toml_edit::Document;

use super::{InputError, Instead, Kept, Problem, Reader, Source};

/// Reads such a file. `what` it is, as in "a plan is TOML"; `remedy` for a quantity that is written with `+-` or `?`.
/// `read` may put the error of another file that it names into its second argument; that one is told alone, for its
/// problems lie there.
///
/// # Errors
/// A file is wrong; the error lists every problem with its place and remedy.
pub fn read_tables<T>(
    source: &Source,
    what: &str,
    remedy: &str,
    read: impl for<'a> FnOnce(&Reader<'a>, &RefCell<Option<InputError>>) -> T,
) -> Result<T, InputError> {
    let document = Document::parse(source.text.to_string()).map_err(|e| {
        let problem = Problem::new(e.message().trim().replace('\n', ", ")).at(e.span());
        let help = format!("{what} is TOML: [table], key = \"value\", # comment");
        InputError::one(source.clone(), problem.help(help))
    })?;
    let broken = RefCell::new(None);
    let (value, mut found) =
        Reader::of_file(document.as_table(), source.folder(), &Kept::default(), Instead::default(), |reader| {
            read(reader, &broken)
        });
    if let Some(error) = broken.take() {
        return Err(error);
    }
    found.problems.extend(found.parameters.iter().map(|parameter| {
        Problem::new(format!("`{}` is written with `+-` or `?`", parameter.path))
            .help(remedy)
            .at(parameter.span.clone())
    }));
    if found.problems.is_empty() { Ok(value) } else { Err(InputError::new(source.clone(), found.problems)) }
}
