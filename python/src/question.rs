//! What is asked of models with measurements.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use fem::ask::{self, Depth, Page, compare_all, refuse_mixed};
use fem::input::Source;
use fem::measure::{Decimal, Measurements, Reading};
use fem::model::Data;
use fem::output::Report;
use fem::process::Process;
use fem::progress::Progress;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::answer::{Answer, tables_of_comparison};
use crate::compute::compute;
use crate::model::Model;

/// Measurements as Python hands them over.
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
}

impl Asked {
    /// Reads them for a process; in a design nothing need have been observed.
    pub fn read(&self, process: &'static dyn Process, is_design: bool) -> Result<Measurements, ask::Error> {
        let decimal = self.decimal.as_deref().map(|mark| if mark == "," { Decimal::Comma } else { Decimal::Point });
        let said = Reading::new(&self.columns, decimal)?;
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

    /// The files among them.
    fn files(&self) -> impl Iterator<Item = PathBuf> {
        self.parts.iter().filter(|(_, text)| text.is_none()).map(|(name, _)| PathBuf::from(name))
    }
}

/// A computation that may take so many seconds.
pub fn within(seconds: Option<f64>) -> Arc<Progress> {
    // A limit that is no time is none.
    Arc::new(Progress::within(seconds.and_then(|s| Duration::try_from_secs_f64(s).ok())))
}

/// Holds models of one process against the same measurements.
#[pyfunction]
pub fn compare<'py>(py: Python<'py>, models: Vec<PyRef<'py, Model>>, data: Asked) -> PyResult<Bound<'py, PyDict>> {
    let models: Vec<_> = models.iter().map(|model| (*model.0).clone()).collect();
    let answer = compute(py, &Arc::default(), move |progress| {
        refuse_mixed(&models)?;
        let Some(first) = models.first() else { return Ok(Answer::default()) };
        let each = |data: &Data, found| (tables_of_comparison(data, &found), found);
        let (compared, measurements) = compare_all(&models, data.read(first.process, false)?, progress, each)?;
        let (tables, comparisons): (Vec<_>, Vec<_>) = compared.into_iter().unzip();
        let report = Report::Comparison(&models, &measurements, &comparisons);
        Ok(Answer { tables, notes: measurements.notes.clone(), ..Answer::of(&report, first)? })
    })?;
    answer.told(py)
}

/// The page of a report, and its notes.
#[pyfunction]
#[pyo3(signature = (models, data, most_effects, seconds))]
pub fn report(
    py: Python,
    models: Vec<PyRef<Model>>,
    data: Option<Asked>,
    most_effects: usize,
    seconds: Option<f64>,
) -> PyResult<(String, Vec<String>)> {
    let models: Vec<_> = models.iter().map(|model| (*model.0).clone()).collect();
    compute(py, &within(seconds), move |progress| {
        refuse_mixed(&models)?;
        let Some(last) = models.last() else { return Ok(Default::default()) };
        let named = models.iter().flat_map(fem::model::Model::paths).chain(data.iter().flat_map(Asked::files));
        let files = named.filter(|path| path.is_file()).collect();
        let measurements = data.as_ref().map(|data| data.read(last.process, false)).transpose()?;
        let page = Page { models: &models, measurements, files, most_effects, depth: Depth::Diagnosed, live: None };
        let made = page.made(progress)?;
        Ok((made.html, made.notes))
    })
}
