//! Rows of a study as CSV: a line each, whatever an error says.

use std::fmt::Write;
use std::fs::File;
use std::io::{self, BufReader};
use std::path::Path;

use crate::study::{Cell, Layout, Row, Summary, Summing};

/// First and last column.
const JOB: &str = "job";
const ERROR: &str = "error";
/// Column of files of measurements.
const DATA: &str = "data";

/// The header, with its line feed.
pub fn header(layout: &Layout) -> String {
    let named = |name: &str, unit: &str| quoted(&with_unit(name, unit));
    let inputs = layout.inputs.iter().map(|(name, unit)| named(name, unit));
    let results = layout.results.iter().map(|r| named(&r.name, &r.unit));
    let data = layout.has_data.then(|| DATA.to_string());
    let all: Vec<String> =
        std::iter::once(JOB.to_string()).chain(inputs).chain(data).chain(results).chain([ERROR.to_string()]).collect();
    all.join(",") + "\n"
}

/// The line of a row, with its line feed: numbers read back exactly.
pub fn line(row: &Row) -> String {
    let mut line = row.job.to_string();
    for value in &row.inputs {
        number(&mut line, *value);
    }
    if let Some(data) = &row.data {
        let _ = write!(line, ",{}", quoted(data));
    }
    for cell in &row.results {
        match cell {
            Cell::Number(value) => number(&mut line, *value),
            Cell::Word(word) => line.push_str(&format!(",{}", quoted(word))),
            Cell::Empty => line.push(','),
        }
    }
    // Writing to a String does not fail, here and below.
    let _ = writeln!(line, ",{}", quoted(&row.error));
    line
}

fn number(line: &mut String, value: f64) {
    let _ = match value.trunc() == value && value.abs() < 1e15 {
        true => write!(line, ",{value}"),
        // With an exponent where there would be many zeros.
        false => write!(line, ",{value:?}"),
    };
}

/// A cell, in quotes where it must be.
fn quoted(cell: &str) -> String {
    let line = cell.split(|c: char| c.is_control()).collect::<Vec<_>>().join(" ");
    if line.contains([',', '"']) { format!("\"{}\"", line.replace('"', "\"\"")) } else { line }
}

/// Summarises the rows of a file.
///
/// # Errors
/// The file cannot be read, or is not as it was written.
pub fn summary(path: &Path, layout: &Layout) -> io::Result<Summary> {
    let mut reader = csv::Reader::from_reader(BufReader::with_capacity(1 << 16, File::open(path)?));
    let mut summing = Summing::new(layout);
    let mut record = csv::StringRecord::new();
    let wrong = || io::Error::new(io::ErrorKind::InvalidData, "a row is not as it was written");
    while reader.read_record(&mut record)? {
        summing.add(&row(&record, layout).ok_or_else(wrong)?);
    }
    Ok(summing.finish())
}

fn row(record: &csv::StringRecord, layout: &Layout) -> Option<Row> {
    let mut cells = record.iter();
    let job = cells.next()?.parse().ok().filter(|job| *job > 0)?;
    let inputs = layout.inputs.iter().map(|_| cells.next()?.parse().ok()).collect::<Option<_>>()?;
    let data = if layout.has_data { Some(cells.next()?.to_string()) } else { None };
    let result = |is_word: bool| {
        Some(match cells.next()? {
            "" => Cell::Empty,
            word if is_word => Cell::Word(word.into()),
            number => Cell::Number(number.parse().ok()?),
        })
    };
    let results = layout.results.iter().map(|r| r.is_word).map(result).collect::<Option<_>>()?;
    Some(Row { job, inputs, data, results, error: cells.next()?.to_string() })
}

/// Number of a line's job, if it is a whole line.
pub fn job_of(line: &[u8]) -> Option<u64> {
    let is_whole = line.ends_with(b"\n") && !line.contains(&0);
    let end = line.iter().position(|byte| *byte == b',').filter(|_| is_whole)?;
    std::str::from_utf8(&line[..end]).ok()?.parse().ok()
}

/// A name with its unit, as a heading has it.
pub fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.into() } else { format!("{name} [{unit}]") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_one_line_and_reads_back() {
        let row = Row {
            job: 7,
            inputs: vec![0.3, 1e-7, 450.0],
            data: Some("a,b.csv".into()),
            results: vec![Cell::Number(-1.25e-9), Cell::Empty, Cell::Word("saddle".into())],
            error: "no \"force\",\nand no depth".into(),
        };
        let told = line(&row);
        assert_eq!(told, "7,0.3,1e-7,450,\"a,b.csv\",-1.25e-9,,saddle,\"no \"\"force\"\", and no depth\"\n");
        assert_eq!((job_of(told.as_bytes()), job_of(told.trim_end().as_bytes())), (Some(7), None));
    }
}
