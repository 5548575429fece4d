//! Pages and notes of a command: pages on stdout, notes on stderr.

use std::io::Write;

use super::error::Error;
use super::look;
use super::say::say;
use crate::input::visible;
use crate::output::{Answer, json, text};

/// Prints to stdout; a reader that has gone away (`fem … | head`) is no error.
pub fn print(text: &str) -> Result<(), Error> {
    let mut out = std::io::stdout().lock();
    match out.write_all(visible(text).as_bytes()).and_then(|()| out.flush()) {
        Err(e) if e.kind() != std::io::ErrorKind::BrokenPipe => Err(Error::Stdout(e)),
        _ => Ok(()),
    }
}

/// An answer for people, or as JSON.
pub fn page(answer: &dyn Answer, is_json: bool) -> String {
    if is_json {
        return json(answer);
    }
    let columns = look::columns();
    look::fitted(&text(answer, columns), columns, look::is_ascii())
}

/// Prints the notes of a file of measurements.
pub fn notes(notes: &[String]) {
    for note in notes {
        say!("note: {note}");
    }
}
