//! The command `fem validate`.

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use crate::budget;
use crate::fit;
use crate::output::Report;
use crate::process::{self, Case};

pub fn validate(args: &args::Validate) -> Result<(), Error> {
    let of_processes = process::validation().flat_map(|(_, cases)| cases);
    let cases: Vec<Case> = of_processes.chain(budget::validation()).chain(fit::validation()).collect();
    print(&page(&Report::Validation(&cases), args.json)?)?;
    if cases.iter().all(Case::passed) { Ok(()) } else { Err(Error::Found) }
}
