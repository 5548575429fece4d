//! `fem correct`.

use std::sync::Arc;

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use super::watch::watched;
use crate::ask::{correct, program, programmed};
use crate::model::Model;
use crate::output::files::Guard;
use crate::output::{CorrectionAnswer, Folder};
use crate::progress::Progress;

pub fn run(args: &args::Correct) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let read = args.program.as_ref().map(|path| program(&model, path)).transpose()?;
    let progress = Arc::new(Progress::default());
    let found = watched(&progress, || correct(&model, &progress))?;
    let own = read.map(|read| programmed(&model, &found, &read, args.add_blocks)).transpose()?;
    let answer = CorrectionAnswer(&model, &found, own.as_ref());
    let mut written = String::new();
    if let Some(directory) = &args.output {
        let mut reads = model.paths();
        reads.extend(args.program.clone());
        let guard = Guard { reads: &reads, force: args.force };
        written = Folder { directory, guard }.write("correct", &answer, &progress)?;
    }
    let list = if args.json { "" } else { &written };
    print(&(page(&answer, args.json) + list))
}
