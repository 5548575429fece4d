//! `fem correct`.

use std::sync::Arc;

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use super::watch::watched;
use crate::ask::{action, correct, program, remedies};
use crate::model::Model;
use crate::output::files::Guard;
use crate::output::{ActionAnswer, Answer, Folder, RemedyAnswer};
use crate::progress::Progress;
use crate::units::TIME;

pub fn run(args: &args::Correct) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let read = args.program.as_ref().map(|path| program(&model, path)).transpose()?;
    let progress = Arc::new(Progress::default());
    if args.remedies {
        return remedied(args, &model, &progress);
    }
    let by = (read.as_ref(), args.add_blocks);
    let found = watched(&progress, || action(&model, by, args.despite_failure, &progress))?;
    tell(args, &model, &ActionAnswer(&model, &found), &progress)
}

/// What to change, beside what to command where the process has a command that is corrected.
fn remedied(args: &args::Correct, model: &Model, progress: &Arc<Progress>) -> Result<(), Error> {
    let limit = args.minutes.map(|minutes| TIME.to_si(minutes));
    let found = watched(progress, || remedies(model, limit, args.despite_failure, progress))?;
    let is_corrected = model.system.commanded().is_some() && (args.json || args.output.is_some());
    let correction =
        is_corrected.then(|| watched(progress, || correct(model, args.despite_failure, progress))).transpose()?;
    let answer =
        RemedyAnswer { model, found: &found, correction: correction.as_ref(), directory: args.output.as_deref() };
    tell(args, model, &answer, progress)
}

/// Writes an answer where it is wanted, and prints it.
fn tell(args: &args::Correct, model: &Model, answer: &impl Answer, progress: &Progress) -> Result<(), Error> {
    let mut written = String::new();
    if let Some(directory) = &args.output {
        let mut reads = model.paths();
        reads.extend(args.program.clone());
        let guard = Guard { reads: &reads, force: args.force };
        written = Folder { directory, guard }.write("correct", answer, progress)?;
    }
    let list = if args.json { "" } else { &written };
    print(&(page(answer, args.json) + list))
}
