//! Writes `residuals.csv`: the measured rows with their predictions and residuals.

use crate::compare::Comparison;
use crate::measure::{FILE_WORD, MeasuredObservable, Measurements};
use crate::units::Unit;

/// Writes the records in their order with `predicted [unit]` and `residual [unit]` in the
/// file's own unit. Where the file has several observables each has two columns of its own, `predicted_NAME`
/// and `residual_NAME`, empty where it was not observed. Rows
/// of several files have the name of theirs in front.
pub fn residuals(measurements: &Measurements, comparison: &Comparison) -> String {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let several_files = measurements.files.len() > 1;
    let file = several_files.then(|| FILE_WORD.to_string());
    let header = file.into_iter().chain(measurements.header.iter().cloned());
    let several = measurements.observables.len() > 1;
    let names = measurements.observables.iter().flat_map(|seen| names(seen, several));
    // Writing to memory does not fail.
    let _ = writer.write_record(header.chain(names));
    let units: Vec<Unit> = measurements.observables.iter().map(unit).collect();
    let mut row = 0;
    let mut reader = measurements.records.reader();
    for number in 0..measurements.records.len() {
        let mut added = vec![String::new(); 2 * measurements.observables.len()];
        while measurements.records_of.get(row) == Some(number) {
            let own = measurements.observable(row);
            let unit = units[own];
            // Nothing has no sign: -0 + 0 is 0.
            added[2 * own] = ((comparison.predicted[row] - unit.offset) / unit.factor + 0.0).to_string();
            added[2 * own + 1] = (comparison.residuals[row] / unit.factor + 0.0).to_string();
            row += 1;
        }
        let file = measurements.file_of_record(number).map(str::to_string);
        let _ =
            writer.write_record(file.into_iter().chain(reader.read(number).iter().map(str::to_string)).chain(added));
    }
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

fn unit(seen: &MeasuredObservable) -> Unit {
    seen.kind.unit_of(&seen.unit).or_else(|_| Unit::parse(&seen.unit)).unwrap_or(seen.kind.canonical())
}

/// Names the two columns of an observable. A residual has no zero point: that of a temperature in degC is in
/// K.
fn names(seen: &MeasuredObservable, several: bool) -> [String; 2] {
    let of = if several { format!("_{}", seen.name) } else { String::new() };
    let residual = if unit(seen).offset == 0.0 { &*seen.unit } else { &*seen.kind.unit };
    [format!("predicted{of} [{}]", seen.unit), format!("residual{of} [{residual}]")]
}
