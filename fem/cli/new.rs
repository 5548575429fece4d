//! `fem new`.

use super::args;
use super::error::Error;
use super::print;
use crate::input::{Problem, did_you_mean};
use crate::output::files;
use crate::process;

pub fn new(args: &args::New) -> Result<(), Error> {
    let Some(process) = process::ALL.iter().find(|p| p.name() == args.process) else {
        let names: Vec<&str> = process::ALL.iter().map(|p| p.name()).collect();
        let meant = did_you_mean(&args.process, names.iter().copied(), '`');
        let problem = Problem::new(format!("`{}` is no process known here", args.process));
        return Err(Error::Request(problem.help(format!("{meant}known are {}", names.join(", ")))));
    };
    let Some(path) = &args.output else { return print(process.starting_model()) };
    if path.exists() {
        let problem = Problem::new(format!("{} exists already", path.display()));
        return Err(Error::Request(problem.help("name a new file with -o")));
    }
    files::write(path, process.starting_model().as_bytes())?;
    print(&format!("written {}; next: fem run {}\n", path.display(), path.display()))
}
