//! Parts shared by the readers of instruments' files: the lines of a text, and the sheet that is made of them.

use std::ops::Range;

use crate::input::{Problem, Source};
use crate::measure::records::Records;
use crate::measure::sheet::Sheet;

/// The file of an instrument.
pub struct Instrument {
    /// Whether a text is one.
    pub is_one: fn(&str) -> bool,
    /// Reads its cells.
    pub read: fn(&Source) -> Result<Sheet, Problem>,
}

/// A line of a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Line<'a> {
    /// Bytes of the text.
    pub place: Range<usize>,
    /// Text of the line, trimmed.
    pub says: &'a str,
}

impl Line<'_> {
    /// A problem in this line.
    pub fn problem(&self, message: String, help: &str) -> Problem {
        Problem::new(message).help(help).at(Some(self.place.clone()))
    }
}

/// The lines of a text.
pub fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut begin = 0;
    text.split('\n').map(move |line| {
        let place = begin..begin + line.trim_end().len();
        begin += line.len() + 1;
        Line { place, says: line.trim_start_matches('\u{feff}').trim() }
    })
}

/// A sheet of records that a reader has made of a file, in which its header stands at `place`.
pub fn sheet(header: Vec<String>, place: Range<usize>, records: Records, told: Vec<String>) -> Sheet {
    // Numbers may have a decimal comma, as beside a semicolon.
    Sheet { separator: ';', header, is_headed: true, place, records, problems: Vec::new(), told }
}
