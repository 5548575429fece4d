//! Files to start from.

use super::Error;
use crate::input::{Problem, did_you_mean};
use crate::output::commented;
use crate::process::{Process, Variant};
use crate::{budget, next, processes, study};

/// The files of a story to try everything on, a model, what was measured, and what was measured of the same job when it was
/// made again with a correction: name and text.
pub const STORY: [(&str, &str); 3] = [
    ("rigid.toml", include_str!("../../models/story/rigid.toml")),
    ("measured.csv", include_str!("../../models/story/measured.csv")),
    ("corrected.csv", include_str!("../../models/story/corrected.csv")),
];

/// A file to start from.
pub struct StartingFile {
    /// Name of its subject: a process, `budget`, `study` or `next`.
    pub name: &'static str,
    /// The same in a sentence.
    pub about: &'static str,
    /// Its text, with a comment on every line.
    pub text: String,
    /// The command that reads it.
    pub command: &'static str,
}

/// All of them, models first.
pub fn starting_files() -> Vec<StartingFile> {
    let of_process = |p: &&'static dyn Process| StartingFile {
        name: p.name(),
        about: p.about(),
        text: format!("{}\n{}", p.starting_model(), commented(*p)),
        command: "run",
    };
    let budget = StartingFile {
        name: "budget",
        about: "errors that are added up, by rules and by drawing",
        text: budget::STARTING.to_string(),
        command: "budget",
    };
    let study = StartingFile {
        name: "study",
        about: "many jobs with one model: a grid, draws or a table",
        text: study::STARTING.to_string(),
        command: "study",
    };
    let next = StartingFile {
        name: "next",
        about: "the log of a machine: what was made, measured and set",
        text: next::STARTING.to_string(),
        command: "next",
    };
    processes::ALL.iter().map(of_process).chain([budget, study, next]).collect()
}

/// The file to start from by its name.
///
/// # Errors
/// There is none.
pub fn starting_file(name: &str) -> Result<StartingFile, Error> {
    let all = starting_files();
    let names: Vec<&str> = all.iter().map(|s| s.name).collect();
    let meant = did_you_mean(name, names.iter().copied(), '`');
    let help = format!("{meant}known are {}", names.join(", "));
    let unknown = || Problem::new(format!("`{name}` is no process known here")).help(help).into();
    all.into_iter().find(|s| s.name == name).ok_or_else(unknown)
}

/// Another model of a process to start from, by the name of the process.
///
/// # Errors
/// There is no such process, or it has no such model.
pub fn starting_variant(name: &str, variant: Variant) -> Result<StartingFile, Error> {
    let file = starting_file(name)?;
    let of = |p: &&'static dyn Process| p.starting_variant(variant).map(|text| (p.name(), text));
    let all: Vec<(&str, &str)> = processes::ALL.iter().filter_map(of).collect();
    let names: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
    match all.iter().find(|(own, _)| *own == name) {
        Some((_, text)) => Ok(StartingFile { text: text.to_string(), ..file }),
        None => {
            let does_not = match variant {
                Variant::Structure => "does not stand on a structure",
                Variant::Sketch => "has no part that is drawn",
            };
            let problem = Problem::new(format!("`{name}` {does_not}"));
            Err(problem.help(format!("`fem new` has one for {}", names.join(", "))).into())
        }
    }
}
