//! Measurements as the command line names them.

use std::path::PathBuf;

use super::args;
use super::error::Error;
use crate::measure::{Decimal, Measurements, Reading};
use crate::process::Process;

impl args::Reading {
    /// How the files are to be read.
    pub fn said(&self) -> Result<Reading, Error> {
        let decimal = self.decimal.map(|mark| match mark {
            args::Mark::Comma => Decimal::Comma,
            args::Mark::Point => Decimal::Point,
        });
        Ok(Reading::new(&self.columns, decimal)?)
    }
}

impl args::Data {
    /// Reads the measurements of a process, of several files as one; their text stays with those that `are_written`
    /// again.
    pub fn load(&self, process: &'static dyn Process, are_written: bool) -> Result<Measurements, Error> {
        let all = Measurements::load_all(&self.with, process, &self.reading.said()?, false)?;
        Ok(if are_written { all } else { all.without_records() })
    }

    /// A model and the files of its measurements, which nothing may overwrite.
    pub fn reads(&self, model: &std::path::Path) -> Vec<PathBuf> {
        std::iter::once(model.to_path_buf()).chain(self.with.iter().cloned()).collect()
    }
}
