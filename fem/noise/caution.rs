//! Cautions about terms that cannot be meant as they stand on the rows of a file.

use super::instrument::time_of;
use super::term::{Acts, Term};
use crate::measure::{FILE, Measurements, grouping_name};
use crate::process::Process;

/// Largest part of the rows that can be single mistakes.
const FEW: f64 = 0.2;

/// Says that a term, resolved to the rows of a file, cannot be meant as it stands, if so, after the name of its table.
pub fn caution(process: &dyn Process, term: &Term, measurements: &Measurements) -> Option<String> {
    let (rows, file) = (measurements.len(), &measurements.name);
    let coordinate = |i: usize| grouping_name(process, i);
    let absent = |i: &&usize| **i != FILE && !measurements.given.contains(i);
    match term.effect.acts {
        Acts::Weighs if term.rows.len() as f64 > FEW * rows as f64 => {
            let count = term.rows.len();
            Some(format!("weighs down {count} of {rows} rows: more than a fifth are no single mistakes"))
        }
        Acts::Neighbours if term.size > rows as f64 => Some(format!(
            "has a length beyond the {rows} rows of {file}: they share one error, which nothing here tells"
        )),
        Acts::Scales if measurements.uncertainty.is_none() => {
            Some(format!("has no effect: {file} has no column u for it to multiply"))
        }
        Acts::Given if measurements.uncertainty.is_some() => {
            Some(format!("takes the place of the column u of {file}, which is not used"))
        }
        Acts::Times(_) => {
            let time = time_of(process).filter(|time| measurements.given.contains(time));
            time.is_none().then(|| format!("has no effect: {file} has no column of times"))
        }
        Acts::Shared(columns) => {
            let columns = columns(term, measurements);
            let is_steady = |column: &[(usize, f64)]| column.len() == rows && column.iter().all(|c| c.1 == column[0].1);
            if columns.is_empty() {
                return Some(format!("has no effect: nothing in {file} differs in what it acts along"));
            }
            let by = term.by.iter().find(absent).map(|i| format!("{file} has no column `{}`", coordinate(*i)));
            let same = || format!("they are all of one group in {file}");
            let is_one = columns.len() == 1 && is_steady(&columns[0]) && !(term.by.is_empty() && term.rows.is_empty());
            is_one.then(|| format!("gives all rows one zero: {}", by.unwrap_or_else(same)))
        }
        _ => None,
    }
}
