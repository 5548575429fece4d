//! The command `fem schema`.

use super::args::SchemaOf;
use super::error::Error;
use super::terminal::print;
use crate::{model, study};

pub fn schema(of: SchemaOf) -> Result<(), Error> {
    let schema = match of {
        SchemaOf::Model => model::schema(),
        SchemaOf::Study => study::schema(),
    };
    print(&format!("{schema:#}\n"))
}
