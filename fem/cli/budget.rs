//! The command `fem budget`.

use std::sync::Arc;

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{page, print};
use super::watch::watched;
use crate::budget::{estimate, load};
use crate::output::{Report, budget_warnings};
use crate::progress::Progress;

pub fn run(args: &args::Budget) -> Result<(), Error> {
    let file = load(&args.file)?;
    let progress = Arc::new(Progress::default());
    let estimate = watched(&progress, || estimate(&file, &progress))?;
    for warning in budget_warnings(&file, estimate.as_ref()) {
        say!("warning: {warning}");
    }
    print(&page(&Report::Budget(&file, estimate.as_ref()), args.json)?)
}
