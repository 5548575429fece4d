//! Measurements as Python hands them over.

use std::path::PathBuf;

use fem::ask;
use fem::input::Source;
use fem::measure::{Decimal, Measurements, Reading};
use fem::model::Model;
use fem::process::Process;
use pyo3::prelude::*;

/// Measurements, and how they are to be read.
#[derive(FromPyObject)]
pub struct Asked {
    /// Files, and tables as CSV, each with its name.
    #[pyo3(item)]
    parts: Vec<(String, Option<String>)>,
    /// Columns that are meant, as the option `--columns` has them.
    #[pyo3(item)]
    columns: Vec<String>,
    /// The decimal mark, `,` or `.`, where it is said.
    #[pyo3(item)]
    decimal: Option<String>,
    /// The line of the headings, from 1, where it is said; 0 where there are none.
    #[pyo3(item)]
    header: Option<usize>,
    /// The sheet of a workbook, where it is said.
    #[pyo3(item)]
    sheet: Option<String>,
    /// Whether readings are taken as they are typed.
    #[pyo3(item)]
    as_typed: bool,
}

impl Asked {
    /// Reads them for a model; in a design nothing need have been observed.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn read(&self, model: &Model, is_design: bool) -> Result<Measurements, ask::Error> {
        let process: &dyn Process = &*model.process;
        let decimal = self.decimal.as_deref().map(|mark| if mark == "," { Decimal::Comma } else { Decimal::Point });
        let headings = self.header.map(|line| (line > 0).then_some(line));
        let said = Reading::new(&self.columns, decimal)?.within(headings, self.sheet.clone()).as_typed(self.as_typed);
        let said = said.over(&model.reading);
        if self.parts.iter().all(|(_, text)| text.is_none()) {
            let paths: Vec<&String> = self.parts.iter().map(|(name, _)| name).collect();
            return Measurements::load_all(&paths, process, &said, is_design).map_err(ask::Error::Data);
        }
        let read = |(name, text): &(String, Option<String>)| match text {
            Some(text) if is_design => Measurements::parse_design(Source::new(&**name, &**text), process, &said),
            Some(text) => Measurements::parse_as(Source::new(&**name, &**text), process, &said),
            None => Measurements::load_all(&[name], process, &said, is_design),
        };
        let all = self.parts.iter().map(read).collect::<Result<Vec<_>, _>>().map_err(ask::Error::Data)?;
        Ok(Measurements::joined(all)?)
    }

    /// Reads them for a model, whose rows then have the columns that they record beside those of the process.
    ///
    /// # Errors
    /// What is wrong with them, or with the model for them.
    pub fn bound(&self, model: &Model, is_design: bool) -> Result<(Model, Measurements), ask::Error> {
        let measurements = self.read(model, is_design)?;
        Ok((model.with_recorded(&measurements.recorded)?, measurements))
    }

    /// The files among them.
    pub fn files(&self) -> impl Iterator<Item = PathBuf> {
        self.parts.iter().filter(|(_, text)| text.is_none()).map(|(name, _)| PathBuf::from(name))
    }
}
