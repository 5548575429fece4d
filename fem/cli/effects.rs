//! The command `fem effects`.

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use crate::ask::catalogue;

pub fn effects(args: &args::Effects) -> Result<(), Error> {
    let catalogue = catalogue(args.name.as_deref())?;
    let text = page(&catalogue.report(), args.json)?;
    let columns = if args.json { String::new() } else { catalogue.columns() };
    print(&(text + &columns))
}
