//! Files of instruments that are no table of columns: one file of this folder for each, one line in [`ALL`].
//!
//! A reader makes of a file the cells that a table would have, with the line in which each stands, and tells what it
//! took and what it left; how cells are read from then on is the same for all files.

mod iso230_report;
mod lines;
mod qdas;
mod rtx;

pub use rtx::text as text_of_rtx;

use lines::Instrument;

use super::sheet::Sheet;
use crate::input::{Problem, Source};

const ALL: &[Instrument] = &[iso230_report::REPORT, qdas::QDAS, rtx::RTX];

/// Reads the cells of an instrument's file; `None` where it is a table of columns, or nothing that is known here.
pub fn read(source: &Source) -> Option<Result<Sheet, Problem>> {
    find(&source.text).map(|instrument| (instrument.read)(source))
}

/// The instrument that wrote a text, if it is no table of columns.
pub fn find(text: &str) -> Option<&'static Instrument> {
    let text = text.trim_start_matches('\u{feff}');
    ALL.iter().find(|instrument| (instrument.is_one)(text))
}
