//! The command `fem import`.

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use crate::ask::look;
use crate::input::{Problem, did_you_mean};
use crate::measure::{Measurements, Reading};
use crate::model::{Model, kept};
use crate::output::files::{self, Guard};
use crate::output::{ImportAnswer, measurements};
use crate::process::Process;
use crate::processes;

pub fn import(args: &args::Import) -> Result<(), Error> {
    let model = args.model.as_ref().map(|path| Model::load(path)).transpose()?;
    let process = match (&args.process, &model) {
        (Some(name), _) => Some(named(name)?),
        (None, Some(model)) => Some(named(model.process.name())?),
        (None, None) => None,
    };
    let own = args.reading.said()?;
    let said = own.clone().over(model.as_ref().map_or(&Reading::default(), |model| &model.reading));
    let mut reads = vec![args.file.clone()];
    reads.extend(args.model.clone());
    let guard = Guard { reads: &reads, force: args.force };
    if let (Some(keep), Some(model)) = (&args.keep, &model) {
        guard.check(keep)?;
        // What is kept reads the file, or it is of no use.
        Measurements::load_as(&args.file, &*model.process, &said)?;
        let new = model.edited(&[kept(&said)])?;
        files::write(keep, new.text_at(keep).as_bytes(), guard)?;
        let (keep, from) = (keep.display(), args.file.display());
        return print(&format!("written {keep}: {} with how files like {from} are read\n", model.source.name));
    }
    if let Some(output) = &args.output {
        guard.check(output)?;
        let found = look(&args.file, process, &said)?;
        let (Some(process), Some(taken)) = (found.process, found.taken) else {
            let problem = Problem::new("of which process the file is cannot be told by its columns");
            return Err(Error::from(problem.help("say it: --process PROCESS; `fem effects` lists all")));
        };
        return written(args, (process, &taken?), output, guard);
    }
    let imported = look(&args.file, process, &said)?;
    let file = args.file.display().to_string();
    let answer = ImportAnswer { file: &file, imported: &imported, said: &own.options() };
    print(&page(&answer, args.json))
}

/// The process of a name.
fn named(name: &str) -> Result<&'static dyn Process, Error> {
    let names = || processes::ALL.iter().map(|p| p.name());
    processes::ALL.iter().copied().find(|p| p.name() == name).ok_or_else(|| {
        let meant = did_you_mean(name, names(), '`');
        let problem = Problem::new(format!("`{name}` is no process known here"));
        let known = names().collect::<Vec<_>>().join(", ");
        Error::from(problem.help(format!("{meant}known are {known}")))
    })
}

/// Writes what was taken of the file.
fn written(
    args: &args::Import,
    (process, taken): (&dyn Process, &Measurements),
    output: &std::path::Path,
    guard: Guard,
) -> Result<(), Error> {
    let text = measurements(taken, process, &format!("Taken from {}.", taken.name));
    files::write(output, text.as_bytes(), guard)?;
    notes(&taken.notes);
    let beside: Vec<String> = taken.recorded.iter().map(|own| format!("`{}`", own.name)).collect();
    if !beside.is_empty() {
        let (name, columns) = (process.name(), if beside.len() == 1 { "the column" } else { "the columns" });
        notes(&[format!(
            "{columns} {} not written: no column of {name}; formulas find them in the file itself",
            beside.join(", ")
        )]);
    }
    let observed: Vec<&str> = taken.observables.iter().map(|o| &*o.name).collect();
    let rows = if taken.len() == 1 { "observation" } else { "observations" };
    let (to, from) = (output.display(), args.file.display());
    print(&format!("written {to}: {} {rows} of {} from {from}\n", taken.len(), observed.join(" and ")))
}
