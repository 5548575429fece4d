//! The command `fem import`.

use super::args;
use super::error::Error;
use super::terminal::{notes, print};
use crate::input::{Problem, did_you_mean};
use crate::measure::Measurements;
use crate::output::files::{self, Guard};
use crate::output::measurements;
use crate::processes;

pub fn import(args: &args::Import) -> Result<(), Error> {
    let Some(process) = processes::ALL.iter().find(|p| p.name() == args.process) else {
        let names = || processes::ALL.iter().map(|p| p.name());
        let meant = did_you_mean(&args.process, names(), '`');
        let problem = Problem::new(format!("`{}` is no process known here", args.process));
        let known = names().collect::<Vec<_>>().join(", ");
        return Err(Error::from(problem.help(format!("{meant}known are {known}"))));
    };
    let reads = [args.file.clone()];
    let guard = Guard { reads: &reads, force: args.force };
    guard.check(&args.output)?;
    let taken = Measurements::load_as(&args.file, *process, &args.reading.said()?)?;
    let text = measurements(&taken, *process, &format!("Taken from {}.", taken.name));
    files::write(&args.output, text.as_bytes(), guard)?;
    notes(&taken.notes);
    let observed: Vec<&str> = taken.observables.iter().map(|o| &*o.name).collect();
    let rows = if taken.len() == 1 { "observation" } else { "observations" };
    let (to, from) = (args.output.display(), args.file.display());
    print(&format!("written {to}: {} {rows} of {} from {from}\n", taken.len(), observed.join(" and ")))
}
