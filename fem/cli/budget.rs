//! The command `fem budget`.

use std::sync::Arc;

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{page, print};
use super::watch::watched;
use crate::budget::Budget;
use crate::output::BudgetAnswer;
use crate::progress::Progress;

pub fn run(args: &args::Budget) -> Result<(), Error> {
    let file = Budget::load(&args.file)?;
    let progress = Arc::new(Progress::default());
    let estimate = watched(&progress, || file.estimate(&progress))?;
    let answer = BudgetAnswer(&file, estimate.as_ref());
    for warning in answer.warnings() {
        say!("warning: {warning}");
    }
    print(&page(&answer, args.json))
}
