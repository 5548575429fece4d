//! Answers on their way to Python: the JSON and the text that a command prints, its figures, and columns as arrays.

use std::borrow::Cow;

use fem::compare::Comparison;
use fem::measure::MeasuredObservable;
use fem::model::{Data, Model, Run};
use fem::output::{self, figures, json, text};
use fem::process::{Column, Observable, Rows, Table, Values};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

/// Tables of a model by their names.
pub type Tables = Vec<(String, Table)>;

/// What a command would print and draw, and more; in Python a dictionary.
#[derive(Default, IntoPyObject)]
pub struct Answer {
    /// The JSON document.
    pub json: String,
    /// The page for people.
    pub text: String,
    /// More than the page, where the command prints that on request.
    pub details: String,
    /// Figures as SVG, by their names.
    pub figures: Vec<(String, String)>,
    /// Tables by their names: those of the model, or of each of several.
    #[pyo3(into_py_with = tables_in_python)]
    pub tables: Vec<Tables>,
    /// Names of columns that say where, when and under which conditions.
    pub coordinates: Vec<String>,
    /// Notes and warnings for people.
    pub notes: Vec<String>,
    /// A model that came of it.
    pub model: Option<crate::handle::Model>,
    /// The model with one effect after the other.
    pub steps: Vec<crate::handle::Model>,
}

impl Answer {
    /// The answer of a command about a model.
    pub fn of(answer: &dyn output::Answer, model: &Model) -> Self {
        Self {
            json: json(answer),
            text: text(answer, None),
            figures: figures(answer),
            coordinates: model.process.coordinates().iter().map(|c| c.name.to_string()).collect(),
            ..Self::default()
        }
    }
}

/// Tables as dictionaries, whose arrays are the columns themselves.
#[expect(clippy::owned_cow, reason = "a field is handed over as its own type")]
fn tables_in_python<'py>(tables: Cow<'_, Vec<Tables>>, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
    // Asked for first, so that its absence is an error and no fault.
    py.import("numpy")?;
    let told = PyList::empty(py);
    for of_model in tables.into_owned() {
        let named = PyDict::new(py);
        for (name, table) in of_model {
            let columns = table.columns.into_iter().map(|column| {
                (
                    column.name.to_string(),
                    column.unit.map(String::from),
                    PyArray1::from_vec(py, column.values),
                    column.words.iter().map(String::from).collect::<Vec<_>>(),
                )
            });
            named.set_item(name, columns.collect::<Vec<_>>())?;
        }
        told.append(named)?;
    }
    Ok(told.into_any())
}

/// The tables of a run: its own, and for each observable what the effects change, point by point.
pub fn tables_of_run(model: &Model, run: &mut Run) -> Tables {
    let profile = std::mem::take(&mut run.report.profile);
    let shown = |name: &str| profile.columns.iter().any(|c| c.name == name);
    let coordinates = model.process.coordinates();
    let shown: Vec<usize> = (0..coordinates.len()).filter(|i| shown(&coordinates[*i].name)).collect();
    let programme = model.system.programme();
    let mut changes = Tables::new();
    for of_observable in run.contributions.chunk_by(|a, b| a.observable == b.observable) {
        let Some(position) = of_observable.first().map(|c| c.observable) else { continue };
        let own = observed_rows(&programme, position);
        let columns = shown.iter().map(|i| Column::coordinate(&coordinates[*i], &programme.columns[*i].some(&own)));
        let observables = model.process.observables();
        let contributions =
            of_observable.iter().map(|c| Column::quantities(c.name.clone(), c.kind(observables), &c.changes));
        let columns = columns.chain(contributions).collect();
        changes.push((format!("changes of {}", observables[position].name), Table { columns }));
    }
    let others = std::mem::take(&mut run.report.tables).into_iter().map(|(name, table)| (name.to_string(), table));
    [("profile".to_string(), profile)].into_iter().chain(others).chain(changes).collect()
}

/// The rows of each observable of a file: coordinates, what was measured, its standard uncertainty, what is predicted,
/// and measured less predicted. Datum directions are taken out of what was measured.
pub fn tables_of_rows(data: &Data, predicted: &[f64], residuals: &[f64], sigma: &Values) -> Tables {
    let rows = data.model.system.resolved(&data.rows);
    data.observables.iter().map(|seen| table_of_rows(data, &rows, seen, [predicted, residuals], sigma)).collect()
}

/// The same of a comparison.
pub fn tables_of_comparison(data: &Data, found: &Comparison) -> Tables {
    tables_of_rows(data, &found.predicted, &found.residuals, &found.noise.sigma)
}

fn table_of_rows(
    data: &Data,
    rows: &Rows,
    seen: &MeasuredObservable,
    [predicted, residuals]: [&[f64]; 2],
    sigma: &Values,
) -> (String, Table) {
    let process = &*data.model.process;
    let observable: &Observable = &process.observables()[seen.position];
    let own = observed_rows(&data.rows, seen.position);
    let of = |column: &[f64]| picked(column, &own);
    let coordinates =
        data.given.iter().map(|i| Column::coordinate(&process.coordinates()[*i], &rows.columns[*i].some(&own)));
    let (kind, of_errors) = (observable.kind, observable.error_kind());
    let values = [
        Column::quantities(observable.name.clone(), kind, &of(&data.observed)),
        Column::quantities("u", of_errors, &sigma.some(&own).to_vec()),
        Column::quantities("predicted", kind, &of(predicted)),
        Column::quantities("residual", of_errors, &of(residuals)),
    ];
    (observable.name.to_string(), Table { columns: coordinates.chain(values).collect() })
}

fn observed_rows(rows: &Rows, observable: usize) -> Vec<usize> {
    (0..rows.len()).filter(|row| rows.observable[*row] == observable).collect()
}

fn picked(column: &[f64], rows: &[usize]) -> Vec<f64> {
    rows.iter().map(|row| column[*row]).collect()
}
