//! Dates and times of day in a column of times: counted in seconds from the first row's.

use super::heading::Heading;
use super::moment::Moment;
use super::records::{RecordReader, Records, Refused};
use crate::input::Problem;

/// Puts dates that have a column of their own before the times of day beside them, as loggers write them; what is told of it.
/// The column of dates is left out then.
pub fn with_dates(headings: &mut Vec<Heading>, records: &mut Records, time: usize) -> Option<String> {
    if records.is_empty() || !headings[time].unit.is_empty() {
        return None;
    }
    let mut reader = records.reader();
    let first = reader.read(0).clone();
    let is_of_day = |cell: &str| Moment::parse(cell).is_some_and(|own| !own.has_date);
    let is_dates = |column: usize, reader: &mut RecordReader<'_>| {
        (0..records.len()).all(|record| Moment::is_date(&reader.read(record)[column]))
    };
    if !is_of_day(&first[time]) {
        return None;
    }
    let unknown = (0..headings.len()).filter(|column| !headings[*column].is_known);
    let mut dates = unknown.filter(|column| Moment::is_date(&first[*column]) && is_dates(*column, &mut reader));
    let (date, None) = (dates.next()?, dates.next()) else { return None };
    drop(reader);
    records.rewrite(&[time], |_, cells, time| Some(format!("{} {}", &cells[date], &cells[time])));
    let told = format!("`{}` with the dates of `{}`", headings[time].written, headings[date].written);
    let kept: Vec<usize> = (0..headings.len()).filter(|column| *column != date).collect();
    records.keep(&kept);
    headings.remove(date);
    Some(told)
}

/// Counts the moments of a column from the first of them, or from the one that its heading says.
///
/// Refuses cells that are no moment of the form of the others, and times of day that fall.
pub fn count(records: &mut Records, column: usize, heading: &mut Heading, notes: &mut Vec<String>) -> Refused {
    let mut reader = records.reader();
    let Some(first) = (0..records.len()).find(|record| !reader.read(*record)[column].is_empty()) else {
        return Refused::default();
    };
    let (text, line) = (reader.read(first)[column].to_string(), records.line(first));
    let (zero, said) = match (&heading.since, Moment::parse(&text)) {
        (Some((said, zero)), _) => (*zero, Some(said.clone())),
        (None, Some(zero)) if heading.unit.is_empty() => (zero, None),
        _ => return Refused::default(),
    };
    let (name, like) = (heading.name.clone(), said.as_ref().unwrap_or(&text));
    let written = heading.written.clone();
    let mut before = f64::NEG_INFINITY;
    let refused = records.rewrite_or_refuse(&[column], |_, cells, column| {
        let text = &cells[column];
        if text.is_empty() {
            return Ok(None);
        }
        match Moment::parse(text).and_then(|moment| moment.after(zero)) {
            Some(seconds) if zero.has_date || seconds >= before => {
                before = seconds;
                Ok(Some(seconds.to_string()))
            }
            Some(_) => Err(Problem::new(format!("`{name}` falls to {text}: is it past midnight?"))
                .help("write dates with the times, 2026-03-01T10:00:00")),
            None => Err(Problem::new(format!("`{text}` in `{name}` is no time like {like}"))
                .help("write all times alike, 2026-03-01T10:00:00, all with a zone or all without")),
        }
    });
    heading.unit = "s".into();
    notes.push(match said {
        Some(said) => format!("`{name}` is counted from {said}, as was said"),
        None => format!(
            "`{name}` is counted from {text}, its first (line {line}); if the model's clock began at another \
             moment, say --columns '{written}={name} since {text}'"
        ),
    });
    refused
}
