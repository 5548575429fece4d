//! Pages and notes of a command: pages on stdout, notes on stderr.

use std::io::Write;

use super::error::Error;
use super::look;
use super::say::say;
use crate::output::{Format, Json, Report, Text};

/// Prints to stdout; a reader that has gone away (`fem … | head`) is no error.
pub fn print(text: &str) -> Result<(), Error> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(Error::Stdout(e)),
        _ => Ok(()),
    }
}

/// A report for people, or as JSON.
pub fn page(report: &Report, json: bool) -> Result<String, Error> {
    if json {
        return Ok(Json.write(report)?);
    }
    let columns = look::columns();
    let text = columns.map_or(Text::default(), |columns| Text { columns }).write(report)?;
    Ok(look::fitted(&text, columns, look::is_ascii()))
}

/// Prints the notes of a file of measurements.
pub fn notes(notes: &[String]) {
    for note in notes {
        say!("note: {note}");
    }
}
