//! The command `fem new`.

use super::args;
use super::error::Error;
use super::terminal::print;
use crate::ask::{StartingFile, starting_file, starting_files, starting_variant};
use crate::input::Problem;
use crate::output::files::{self, Guard};
use crate::process::Variant;

pub fn new(args: &args::New) -> Result<(), Error> {
    let Some(name) = &args.process else { return print(&listed()) };
    let StartingFile { text, command, .. } =
        variant(args).map_or_else(|| starting_file(name), |variant| starting_variant(name, variant))?;
    let Some(path) = &args.output else { return print(&text) };
    if path.exists() {
        let problem = Problem::new(format!("{} exists already", path.display()));
        return Err(problem.help("name a new file with -o").into());
    }
    files::write(path, text.as_bytes(), Guard { reads: &[], force: false })?;
    print(&format!("written {}; next: fem {command} {}\n", path.display(), path.display()))
}

/// What more is asked of the model than the plain one has.
fn variant(args: &args::New) -> Option<Variant> {
    match (args.structure, args.sketch) {
        (true, _) => Some(Variant::Structure),
        (_, true) => Some(Variant::Sketch),
        _ => None,
    }
}

/// Lists everything that can be modelled, and the first commands.
fn listed() -> String {
    let files = starting_files();
    let all: String = files.iter().map(|file| format!("  {:<11} {}\n", file.name, file.about)).collect();
    let first = files.first().map_or("", |file| file.name);
    format!(
        "a model says what is made and on what; these can be modelled\n{all}
  fem new {first} -o model.toml   writes a model in which every line is explained; change it to yours
  fem run model.toml              predicts
  fem effects {first}             what else could be happening, to be added to the model
"
    )
}
