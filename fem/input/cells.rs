//! Cells of CSV files: headers of `name [unit]`, numbers, and the lines that problems point at.

use std::ops::Range;

use super::{Problem, Source};
use crate::units::LARGEST;

/// Name and unit of a header cell `name [unit]`; the unit is empty where there is none.
pub fn name_and_unit(cell: &str) -> (&str, &str) {
    match cell.trim().split_once('[') {
        Some((name, unit)) => (name.trim(), unit.trim().trim_end_matches(']').trim()),
        None => (cell.trim(), ""),
    }
}

/// The finite number of a cell.
///
/// # Errors
/// The cell is empty, or holds something else; the problem has no place yet.
pub fn number(cell: &str, column: &str) -> Result<f64, Problem> {
    if cell.is_empty() {
        return Err(Problem::new(format!("the cell of `{column}` is empty")).help("every cell needs a number"));
    }
    match cell.parse::<f64>() {
        Ok(value) if value.abs() <= LARGEST => Ok(value),
        Ok(value) if value.is_finite() => {
            Err(Problem::new(format!("`{cell}` in `{column}` is too large to be measured"))
                .help("are the exponent and the columns right?"))
        }
        _ => Err(Problem::new(format!("`{cell}` in `{column}` is no finite number"))
            .help("write a number with a decimal point")),
    }
}

/// Refuses a header that is one cell because semicolons part its columns.
///
/// # Errors
/// It is; the problem has no place yet.
pub fn parted_by_commas<'a>(mut header: impl Iterator<Item = &'a str>) -> Result<(), Problem> {
    match (header.next(), header.next()) {
        (Some(all), None) if all.contains(';') => {
            let problem = Problem::new("the columns are parted by semicolons");
            Err(problem.help("part them by commas, and write decimals with a point"))
        }
        _ => Ok(()),
    }
}

/// Bytes of the line that begins at `offset` of `text`, which itself begins `skipped` bytes into its file;
/// the position of a CSV reader may stand before comments.
pub fn line_at(text: &str, offset: usize, skipped: usize) -> Range<usize> {
    let mut start = offset;
    while let Some(line) = text.get(start..).and_then(|rest| rest.lines().next()) {
        if !(line.trim().is_empty() || line.starts_with('#')) {
            return start + skipped..start + line.trim_end().len() + skipped;
        }
        start += line.len() + text[start + line.len()..].find('\n').map_or(1, |i| i + 1);
    }
    offset + skipped..offset + skipped
}

/// The problem with the line of the file that it is about.
pub(super) fn on_line(source: &Source, problem: Problem) -> Problem {
    let line = problem.span.as_ref().map(|span| source.line_column(span.start).0);
    let message = line.map_or(problem.message.clone(), |line| format!("line {line}: {}", problem.message));
    Problem { message, ..problem }
}

/// The problem of a file, whose text begins `skipped` bytes into it, that is no CSV.
pub fn no_csv(error: &csv::Error, skipped: usize) -> Problem {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let span = pos.as_ref().map(|p| p.byte() as usize + skipped).map(|b| b..b + 1);
            Problem::new(format!("the row has {len} cells, the header {expected_len}"))
                .help("give every row one cell per column")
                .at(span)
        }
        _ => Problem::new(format!("the file cannot be read as CSV: {error}")).help("check quotes and separators"),
    }
}
