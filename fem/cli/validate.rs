//! The command `fem validate`.

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use crate::budget;
use crate::output::Report;
use crate::process::{self, Case};

pub fn validate(args: &args::Validate) -> Result<(), Error> {
    let cases: Vec<Case> = process::validation().flat_map(|(_, cases)| cases).chain(budget::validation()).collect();
    print(&page(&Report::Validation(&cases), args.json)?)?;
    if cases.iter().all(Case::passed) { Ok(()) } else { Err(Error::Found) }
}
