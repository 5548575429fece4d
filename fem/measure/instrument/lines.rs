//! What the readers of instruments' files share: the lines of a text, and the sheet that is made of them.

use std::ops::Range;

use crate::input::{Problem, Source};
use crate::measure::sheet::{Row, Sheet};

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
    /// Number, from 1.
    pub number: u64,
    /// Bytes of the text.
    pub place: Range<usize>,
    /// What it says, without blanks around it.
    pub says: &'a str,
}

impl Line<'_> {
    /// A row of a sheet that stands in this line.
    pub fn row<'c>(&self, cells: impl IntoIterator<Item = &'c str>) -> Row {
        Row { cells: cells.into_iter().collect(), place: self.place.clone(), line: self.number }
    }

    /// A problem in this line.
    pub fn problem(&self, message: String, help: &str) -> Problem {
        Problem::new(message).help(help).at(Some(self.place.clone()))
    }
}

/// The lines of a text.
pub fn lines(text: &str) -> impl Iterator<Item = Line<'_>> {
    let mut begin = 0;
    text.split('\n').zip(1..).map(move |(line, number)| {
        let place = begin..begin + line.trim_end().len();
        begin += line.len() + 1;
        Line { number, place, says: line.trim_start_matches('\u{feff}').trim() }
    })
}

/// A sheet of columns that a reader has made, in a file whose first line is its header.
pub fn sheet(header: Vec<String>, place: Range<usize>, rows: Vec<Row>, told: Vec<String>) -> Sheet {
    // Numbers may have a decimal comma, as beside a semicolon.
    Sheet { separator: ';', header, place, rows, problems: Vec::new(), told }
}
