//! The first rows of a file as it stands, for somebody who has to say what its columns are.

use std::path::Path;

use super::heading::Heading;
use super::instrument::{self, text_of_rtx};
use super::read::LARGEST_FILE;
use super::sheet;
use super::vocabulary::Vocabulary;
use crate::input::{InputError, Source, name_and_unit};
use crate::process::Process;

/// Most rows that are shown.
const SHOWN: usize = 6;

/// Most characters of a cell.
const WIDEST: usize = 80;

/// Headings and first rows, cell by cell, with nothing understood of them yet.
#[derive(Clone, Debug)]
pub struct Preview {
    /// Cells of the header.
    pub headings: Vec<String>,
    /// Cells of the first rows.
    pub rows: Vec<Vec<String>>,
    /// Number of all rows.
    pub count: usize,
}

/// The column that each heading is read as by itself, `name [unit]`; `None` where a process knows none of the name.
pub fn meant(headings: &[String], process: &dyn Process) -> Vec<Option<String>> {
    let names: Vec<String> = headings.iter().map(|cell| name_and_unit(cell).0.to_string()).collect();
    let read = |cell: &String| Heading::read(cell, Vocabulary::of(process), &names).ok().filter(|own| own.is_known);
    headings.iter().map(|cell| read(cell).map(|own| own.cell())).collect()
}

impl Preview {
    /// Looks at a file.
    ///
    /// # Errors
    /// It cannot be read, or is no table.
    pub fn of(path: &Path) -> Result<Self, InputError> {
        let source = Source::read_exported(path, LARGEST_FILE, text_of_rtx)?;
        let sheet = instrument::read(&source).unwrap_or_else(|| sheet::read(&source));
        let sheet = sheet.map_err(|problem| InputError::one(source, problem))?;
        let shown = (0..sheet.records.len()).take(SHOWN);
        let rows = shown.map(|row| sheet.records.get(row).iter().map(cut).collect()).collect();
        Ok(Self { headings: sheet.header.iter().map(|own| cut(own)).collect(), rows, count: sheet.records.len() })
    }
}

/// What no longer has room in a cell is left out.
fn cut(cell: &str) -> String {
    cell.chars().take(WIDEST).collect()
}
