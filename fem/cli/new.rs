//! The command `fem new`.

use super::args;
use super::error::Error;
use super::terminal::print;
use crate::budget;
use crate::input::{Problem, did_you_mean};
use crate::output::commented;
use crate::output::files::{self, Guard};
use crate::process;
use crate::study;

/// Name of a starting file, its text, and the command that reads it.
type Start = (&'static str, String, &'static str);

pub fn new(args: &args::New) -> Result<(), Error> {
    let Some(name) = &args.process else { return print(&listed()) };
    let (text, command) = start(name)?;
    let Some(path) = &args.output else { return print(&text) };
    if path.exists() {
        let problem = Problem::new(format!("{} exists already", path.display()));
        return Err(Error::Request(problem.help("name a new file with -o")));
    }
    files::write(path, text.as_bytes(), Guard { reads: &[], force: false })?;
    print(&format!("written {}; next: fem {command} {}\n", path.display(), path.display()))
}

/// The commented model to start from, of a process, or the file of a budget or a study.
///
/// # Errors
/// There is no such process.
pub fn starting_file(name: &str) -> Result<String, Error> {
    start(name).map(|(text, _)| text)
}

/// A starting file by its name, and the command that reads it.
fn start(name: &str) -> Result<(String, &'static str), Error> {
    let starts: Vec<Start> = process::ALL
        .iter()
        .map(|p| (p.name(), format!("{}\n{}", p.starting_model(), commented(*p)), "run"))
        .chain([("budget", budget::STARTING.to_string(), "budget"), ("study", study::STARTING.to_string(), "study")])
        .collect();
    let Some((_, text, command)) = starts.iter().find(|s| s.0 == name) else {
        let names: Vec<&str> = starts.iter().map(|s| s.0).collect();
        let meant = did_you_mean(name, names.iter().copied(), '`');
        let problem = Problem::new(format!("`{name}` is no process known here"));
        return Err(Error::Request(problem.help(format!("{meant}known are {}", names.join(", ")))));
    };
    Ok((text.clone(), *command))
}

/// What can be modelled, and how to begin.
fn listed() -> String {
    let about = |name: &str, about: &str| format!("  {name:<11} {about}\n");
    let all: String = process::ALL.iter().map(|p| about(p.name(), p.about())).collect();
    let first = process::ALL.first().map_or("", |p| p.name());
    format!(
        "a model says what is made and on what; these can be modelled\n{all}{}{}
  fem new {first} -o model.toml   writes a model in which every line is explained; change it to yours
  fem run model.toml              predicts
  fem effects {first}             what else could be happening, to be added to the model
",
        about("budget", "errors that are added up, by rules and by drawing"),
        about("study", "many jobs with one model: a grid, draws or a table")
    )
}
