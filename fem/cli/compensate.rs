//! `fem compensate`.

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::compensate::compensate;
use crate::input::Problem;
use crate::model::{Data, Model};
use crate::output::files::Guard;
use crate::output::{Folder, Format, LINUXCNC, Report};
use crate::progress::Progress;

pub fn run(args: &args::Compensate) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let Some(axis) = model.system.positioning() else {
        let problem = Problem::new(format!("{} models {}", model.source.name, model.process.about()));
        let help = "compensation is for axes that are tested by going to targets from both sides";
        return Err(Error::Request(problem.help(help)));
    };
    let data = Data::of(&model, args.data.load(model.process)?)?;
    let found = watched(&data.progress, || compensate(&data, axis))?;
    let report = Report::Compensation(&data, &found);
    let mut written = String::new();
    if let Some(directory) = &args.output {
        let reads = args.data.reads(&args.model);
        written =
            Folder { directory, guard: Guard { reads: &reads, force: args.force }, progress: &Progress::default() }
                .write(&report)?;
        if !written.contains(LINUXCNC) {
            say!("note: no {LINUXCNC}: it takes fewer targets than these");
        }
    }
    notes(&data.notes);
    let list = if args.json { "" } else { &written };
    print(&(page(&report, args.json)? + list))
}
