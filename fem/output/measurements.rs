//! Writes measurements as a file in the program's own form.

use crate::input::name_and_unit;
use crate::measure::{Measurements, is_column};
use crate::process::Process;

/// A measurement file of the rows that were taken and the columns that are used, with `about` as a comment
/// above.
pub fn measurements(measurements: &Measurements, process: &dyn Process, about: &str) -> String {
    let is_used = |cell: &String| is_column(process, name_and_unit(cell).0);
    let used: Vec<usize> = (0..measurements.header.len()).filter(|i| is_used(&measurements.header[*i])).collect();
    let mut taken: Vec<usize> = measurements.records_of.iter().collect();
    taken.sort_unstable();
    taken.dedup();
    let mut writer = csv::Writer::from_writer(Vec::new());
    // Writing to memory does not fail.
    let _ = writer.write_record(used.iter().map(|i| &measurements.header[*i]));
    let mut reader = measurements.records.reader();
    for record in taken.into_iter().filter(|record| *record < measurements.records.len()) {
        let record = reader.read(record);
        let _ = writer.write_record(used.iter().map(|i| record.get(*i).unwrap_or_default()));
    }
    let rows = String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default();
    let about = about.replace(['\n', '\r'], " ");
    format!("# {about}\n{rows}")
}
