//! Rows that are to be measured next, as a measurement file to fill in.

use super::csv;
use super::fit::Short;
use crate::compare::rms;
use crate::diagnose::Next;
use crate::model::Data;
use crate::process::{Absent, Column, Coordinate, Table};

/// A measurement file with the rows of an experiment, where the cells of what is observed are empty: a row whose cell
/// stays empty counts for nothing. A column of uncertainties has those of the data, where these have some.
pub fn rows_to_measure(data: &Data, next: &Next) -> String {
    let rows = next.experiment.rows.some(&repeated(next));
    let coordinates = data.model.process.coordinates().iter().zip(&rows.columns);
    // What a column says that nobody needs to write is left out.
    let is_said = |coordinate: &Coordinate, value: &f64| {
        !value.is_nan() && !matches!(coordinate.absent, Absent::Value(usual) if usual == *value)
    };
    let said = coordinates.filter(|(coordinate, values)| values.iter().any(|value| is_said(coordinate, value)));
    let mut columns: Vec<Column> = said.map(|(coordinate, values)| Column::coordinate(coordinate, values)).collect();
    let observed: Vec<_> = data.observables.iter().filter(|o| rows.observable.contains(&o.position)).collect();
    for seen in &observed {
        columns.push(Column::numbers(seen.name.clone(), Some(&seen.unit), vec![f64::NAN; rows.len()]));
    }
    if let Some(known) = &data.uncertainty {
        for seen in &observed {
            let name = if data.observables.len() == 1 { "u".to_string() } else { format!("u_{}", seen.name) };
            let own = (0..data.len()).filter(|row| data.observable(*row) == seen.position);
            let own: Vec<f64> = own.map(|row| known[row]).collect();
            let usual = Short(seen.kind.from_si(rms(&own))).to_string();
            let usual: f64 = usual.parse().unwrap_or(f64::NAN);
            let of = |row: usize| if rows.observable[row] == seen.position { usual } else { f64::NAN };
            columns.push(Column::numbers(name, Some(&seen.kind.unit), (0..rows.len()).map(of).collect()));
        }
    }
    format!("# {}\n{}", next.experiment.words.replace(['\n', '\r'], " "), csv::table(&Table { columns }))
}

/// The rows of an experiment in the order of measuring, which is made again as a whole.
fn repeated(next: &Next) -> Vec<usize> {
    (0..next.repeats).flat_map(|_| 0..next.experiment.rows.len()).collect()
}
