//! `fem next`.

use std::sync::Arc;

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::ask::{Change, Log};
use crate::measure::Measurements;
use crate::output::NextAnswer;
use crate::output::files::{self, Appended};
use crate::progress::Progress;

pub fn run(args: &args::Next) -> Result<(), Error> {
    let mut file = Appended::open(&args.log)?;
    let mut log = Log::read(&args.log.display().to_string(), file.bytes())?;
    let job = log.job(args.job.as_deref())?;
    let measured = match args.with.is_empty() {
        true => None,
        false => {
            let model = &log.history.jobs[job].model;
            let said = args.reading.said()?.over(&model.reading);
            Some(Measurements::load_all(&args.with, &*model.process, &said, false)?)
        }
    };
    let change = Change {
        insert: args.new_insert,
        set_up: args.new_set_up,
        pause: args.pause.unwrap_or(0.0),
        job: args.next_job.clone(),
    };
    let reads = [std::slice::from_ref(&args.log), &args.with].concat();
    if let Some(page) = &args.page {
        files::page_guard(page, &reads, args.force).check(page)?;
    }
    let progress = Arc::new(Progress::default());
    let own = measured.as_ref().map(|measured| (job, measured));
    let (next, added) = watched(&progress, || log.next(own, args.applied, &change, &progress))?;
    if !args.dry_run && !added.entry.is_empty() {
        file.append(added.whole, &added.entry)?;
    }
    notes(&log.notes);
    notes(measured.as_ref().map_or(&[], |measured| &measured.notes));
    let answer = NextAnswer(&log.history, &next);
    let mut written = String::new();
    if let Some(page) = &args.page {
        files::write_page(page, &answer.page(), &reads, args.force)?;
        written = if args.json { written } else { format!("\nwritten {}\n", page.display()) };
    }
    print(&(page(&answer, args.json) + &written))
}
