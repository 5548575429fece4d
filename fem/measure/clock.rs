//! Dates and times of day in a column of times: counted in seconds from the first row's.

use super::heading::Heading;
use super::moment::Moment;
use super::records::{Records, Refused};
use crate::input::Problem;

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
