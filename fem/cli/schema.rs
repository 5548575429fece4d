//! `fem schema`.

use super::error::Error;
use super::print;
use crate::model;

pub fn schema() -> Result<(), Error> {
    print(&format!("{:#}\n", model::schema()))
}
