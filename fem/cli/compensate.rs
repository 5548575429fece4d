//! `fem compensate`.

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::ask::{compensate, read};
use crate::compensate::Compensation;
use crate::input::Problem;
use crate::model::Data;
use crate::output::files::Guard;
use crate::output::{CONTROLS, CompensationAnswer, Control, Folder, LINUXCNC, Supplied, supplied};

pub fn run(args: &args::Compensate) -> Result<(), Error> {
    let is_asked = |control: &&Control| args.controls.iter().any(|name| name == control.name);
    let controls: Vec<&'static Control> = CONTROLS.iter().filter(is_asked).collect();
    let (model, measured) = read(&args.model, |process, kept| args.data.load(process, kept, false))?;
    let data = Data::of(&model, measured)?;
    let found = watched(&data.progress, || compensate(&data))?;
    let files = match &controls[..] {
        [] => supplied(&CONTROLS[0], &found, &args.axis, false).into_iter().collect(),
        asked => asked.iter().map(|control| asked_for(control, &found, &args.axis)).collect::<Result<Vec<_>, _>>()?,
    };
    let answer = CompensationAnswer(&data, &found, &files);
    let mut written = String::new();
    if let Some(directory) = &args.output {
        let reads = args.data.reads(&args.model);
        let guard = Guard { reads: &reads, force: args.force };
        written = Folder { directory, guard }.write("compensate", &answer, &data.progress)?;
        if files.is_empty() {
            say!("note: no {LINUXCNC}: it takes fewer targets than these");
        }
    }
    notes(&data.notes);
    let list = if args.json { "" } else { &written };
    print(&(page(&answer, args.json) + list))
}

/// Files for a control that the user has named.
fn asked_for(control: &'static Control, found: &Compensation, axis: &str) -> Result<Supplied, Error> {
    supplied(control, found, axis, true).map_err(|why| {
        let problem = Problem::new(format!("{} cannot hold this table", control.name));
        Error::from(problem.help(why))
    })
}
