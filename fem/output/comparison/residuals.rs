//! `residuals.csv`: the measured rows with their prediction and what is left.

use crate::compare::Comparison;
use crate::measure::Measurements;
use crate::units::Unit;

/// The rows in their order, as written, with `predicted [unit]` and `residual [unit]` in the file's own unit.
pub fn residuals(measurements: &Measurements, comparison: &Comparison) -> String {
    let unit = Unit::parse(&measurements.unit).unwrap_or(measurements.kind.canonical());
    let name = &measurements.unit;
    let mut writer = csv::Writer::from_writer(Vec::new());
    let header = measurements.header.iter().cloned();
    // Writing to memory does not fail.
    let _ = writer.write_record(header.chain([format!("predicted [{name}]"), format!("residual [{name}]")]));
    for ((record, predicted), residual) in
        measurements.records.iter().zip(&comparison.predicted).zip(&comparison.residuals)
    {
        let cells = record.iter().map(str::to_string);
        let predicted = ((predicted - unit.offset) / unit.factor).to_string();
        let residual = (residual / unit.factor).to_string();
        let _ = writer.write_record(cells.chain([predicted, residual]));
    }
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}
