//! `fem discover`.

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use super::watch::watched;
use super::written::write_model;
use crate::ask::{read, with_usual};
use crate::discover::{discover, read_candidates};
use crate::model::Data;
use crate::output::LawsAnswer;
use crate::output::files::Guard;

pub fn run(args: &args::Discover) -> Result<(), Error> {
    let reads = args.data.reads(&args.model);
    let guard = Guard { reads: &reads, force: args.force };
    if let Some(new) = &args.add_to {
        guard.check(new)?;
    }
    let candidates = read_candidates(&args.own.candidates)?;
    let (model, measured) = read(&args.model, |process, kept| args.data.load(process, kept, false))?;
    let progress = args.limit.progress();
    let data = Data::of(&model, measured)?.watched(progress.clone());
    let found = watched(&progress, || discover(&data, &candidates, &progress))?;
    if let (Some(new), Some(better)) = (&args.add_to, found.told().and_then(|law| law.model.as_ref())) {
        write_model(new, &with_usual(better.clone())?, data.model, guard)?;
    }
    notes(&data.notes_of_fit());
    print(&page(&LawsAnswer(&data, &found), args.json))
}
