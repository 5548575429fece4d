//! The command `fem effects`.

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use crate::ask::catalogue;
use crate::output::columns;

pub fn effects(args: &args::Effects) -> Result<(), Error> {
    let catalogue = catalogue(args.name.as_deref())?;
    let text = page(&catalogue.report(), args.json)?;
    let columns = catalogue.process.filter(|_| !args.json).map_or(String::new(), |p| format!("\n{}", columns(p)));
    print(&(text + &columns))
}
