//! `fem compensate`.

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::compensate::{Compensation, compensate};
use crate::input::Problem;
use crate::model::{Data, Model};
use crate::output::files::Guard;
use crate::output::{CONTROLS, Control, Folder, Format, LINUXCNC, Report, Supplied, supplied};
use crate::process::Positioning;
use crate::progress::Progress;

pub fn run(args: &args::Compensate) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let axis = axis_of(&model)?;
    let is_asked = |control: &&Control| args.controls.iter().any(|name| name == control.name);
    let controls: Vec<&'static Control> = CONTROLS.iter().filter(is_asked).collect();
    let data = Data::of(&model, args.data.load(model.process, false)?)?;
    let found = watched(&data.progress, || compensate(&data, axis))?;
    let files = match &controls[..] {
        [] => supplied(&CONTROLS[0], &found, &args.axis, false).into_iter().collect(),
        asked => asked.iter().map(|control| asked_for(control, &found, &args.axis)).collect::<Result<Vec<_>, _>>()?,
    };
    let report = Report::Compensation(&data, &found, &files);
    let mut written = String::new();
    if let Some(directory) = &args.output {
        let reads = args.data.reads(&args.model);
        written =
            Folder { directory, guard: Guard { reads: &reads, force: args.force }, progress: &Progress::default() }
                .write(&report)?;
        if files.is_empty() {
            say!("note: no {LINUXCNC}: it takes fewer targets than these");
        }
    }
    notes(&data.notes);
    let list = if args.json { "" } else { &written };
    print(&(page(&report, args.json)? + list))
}

/// What a model says of a positioning test.
///
/// # Errors
/// It models none.
pub fn axis_of(model: &Model) -> Result<&dyn Positioning, Error> {
    model.system.positioning().ok_or_else(|| {
        let problem = Problem::new(format!("{} models {}", model.source.name, model.process.about()));
        let help = "compensation is for axes that are tested by going to targets from both sides";
        Error::Request(problem.help(help))
    })
}

/// Files for a control that the user has named.
fn asked_for(control: &'static Control, found: &Compensation, axis: &str) -> Result<Supplied, Error> {
    supplied(control, found, axis, true).map_err(|why| {
        let problem = Problem::new(format!("{} cannot hold this table", control.name));
        Error::Request(problem.help(why))
    })
}
