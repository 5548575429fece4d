//! `fem fit`.

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::ask::{fit, fitted, read};
use crate::model::Data;
use crate::output::FitAnswer;
use crate::output::files::{self, Guard};

pub fn run(args: &args::Fit) -> Result<(), Error> {
    let reads = args.data.reads(&args.model);
    let guard = Guard { reads: &reads, force: args.force };
    if let Some(new) = &args.add_to {
        guard.check(new)?;
    }
    let (model, measured) = read(&args.model, |process, kept| args.data.load(process, kept, false))?;
    let data = Data::of(&model, measured)?.watched(args.limit.progress());
    let fit = watched(&data.progress, || fit(&data))?;
    if let Some(new) = &args.add_to {
        // A fitted value outside its bounds would make a file that cannot be read: better none.
        let fitted = fitted(&data, &fit)?;
        files::write(new, fitted.text_at(new).as_bytes(), guard)?;
        say!("written {}", new.display());
        let sizes = fit.sizes.iter().filter(|s| !s.is_told()).map(|s| &s.estimate);
        for open in fit.estimates.iter().filter(|e| !e.is_closed()).chain(sizes) {
            say!("note: {} stays as it was: the data leave its interval open", open.parameter.path);
        }
    }
    notes(&data.notes_of_fit());
    print(&page(&FitAnswer(&data, &fit), args.json))
}
