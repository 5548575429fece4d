//! The command `fem schema`.

use super::error::Error;
use super::terminal::print;
use crate::model;

pub fn schema() -> Result<(), Error> {
    print(&format!("{:#}\n", model::schema()))
}
