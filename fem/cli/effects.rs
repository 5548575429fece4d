//! The command `fem effects`.

use super::args;
use super::error::Error;
use super::terminal::{page, print};
use crate::ask::catalogue;

pub fn effects(args: &args::Effects) -> Result<(), Error> {
    print(&page(&catalogue(args.name.as_deref())?, args.json))
}
