//! `fem fit`.

use std::path::Path;

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use super::watch::watched;
use super::written::{note_open, write_model};
use crate::ask::{fit, fitted, read};
use crate::fit::Fit;
use crate::model::Data;
use crate::output::FitAnswer;
use crate::output::files::Guard;

pub fn run(args: &args::Fit) -> Result<(), Error> {
    let reads = args.data.reads(&args.model);
    let guard = Guard { reads: &reads, force: args.force };
    if let Some(new) = &args.add_to {
        guard.check(new)?;
    }
    let (model, measured) = read(&args.model, |process, kept| args.data.load(process, kept, false))?;
    let data = Data::of(&model, measured)?.watched(args.limit.progress());
    let fit = watched(&data.progress, || fit(&data))?;
    // What was found is told, whether or not it makes a model.
    let written = args.add_to.as_ref().map_or(Ok(()), |new| write(new, (&data, &fit), guard));
    notes(&data.notes_of_fit());
    print(&page(&FitAnswer(&data, &fit), args.json))?;
    written
}

/// Writes the fitted model; one that could not be read again, or run, is none.
fn write(new: &Path, (data, fit): (&Data, &Fit), guard: Guard) -> Result<(), Error> {
    write_model(new, &fitted(data, fit)?, data.model, guard)?;
    let sizes = fit.sizes.iter().filter(|s| !s.is_told()).map(|s| &s.estimate);
    note_open(fit.estimates.iter().filter(|e| !e.is_closed()).chain(sizes));
    Ok(())
}
