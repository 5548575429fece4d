//! `fem validate`.

use super::args;
use super::error::Error;
use super::print;
use crate::budget;
use crate::output::{json, text};
use crate::process::{self, Case};

pub fn validate(args: &args::Validate) -> Result<(), Error> {
    let cases: Vec<Case> = process::ALL.iter().flat_map(|p| p.validation()).chain(budget::validation()).collect();
    print(&if args.json { format!("{:#}\n", json::validation(&cases)) } else { text::validation(&cases) })?;
    if cases.iter().all(Case::passed) { Ok(()) } else { Err(Error::Found) }
}
