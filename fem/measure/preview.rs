//! The first rows of a file as it stands, and what its columns are read as, for somebody who may have to say it.

use super::exported::Exported;
use super::reading::{self, Reading};
use super::vocabulary::Vocabulary;
use super::{Measurements, header_rows, worded};
use crate::input::{InputError, name_and_unit};
use crate::process::Process;

/// Most rows that are shown.
const SHOWN: usize = 6;

/// Most characters of a cell.
const WIDEST: usize = 80;

/// Headings and first rows, cell by cell.
#[derive(Clone, Debug)]
pub struct Preview {
    /// Cells of the header; numbers of the columns where the file has no headings.
    pub headings: Vec<String>,
    /// Whether the file has headings.
    pub is_headed: bool,
    /// The column that each is read as, `name [unit]`; `None` where a process knows none of the name.
    pub meant: Vec<Option<String>>,
    /// Cells of the first rows.
    pub rows: Vec<Vec<String>>,
    /// Number of all rows.
    pub count: usize,
    /// How the file was read where it is not written as the program writes its own.
    pub told: Vec<String>,
}

/// A file, and what was made of it.
pub struct Imported {
    /// The process whose measurements it holds: the one that was said, or of which most is understood.
    pub process: Option<&'static dyn Process>,
    /// Others of which it could be as well.
    pub others: Vec<&'static dyn Process>,
    /// Its first rows.
    pub preview: Preview,
    /// What was taken, or why nothing was.
    pub taken: Option<Result<Measurements, InputError>>,
}

impl Preview {
    /// Looks at a file, of a process where that is known.
    ///
    /// # Errors
    /// It is no table.
    pub fn of(file: &Exported, process: Option<&dyn Process>, said: &Reading) -> Result<Self, InputError> {
        let mut sheet = file.sheet(said).map_err(|problem| InputError::one(file.source.clone(), problem))?;
        let vocabulary = process.map(Vocabulary::of);
        if let Some(vocabulary) = vocabulary {
            header_rows::settle(&mut sheet, vocabulary, said);
        }
        let shown = (0..sheet.records.len()).take(SHOWN);
        let rows = shown.map(|row| sheet.records.get(row).iter().map(cut).collect()).collect();
        let names: Vec<String> = sheet.header.iter().map(|cell| name_and_unit(cell).0.to_string()).collect();
        let read = |cell: &String| meant(cell, &names, vocabulary?, said);
        Ok(Self {
            meant: sheet.header.iter().map(read).collect(),
            headings: sheet.header.iter().map(|own| cut(own)).collect(),
            is_headed: sheet.is_headed,
            rows,
            count: sheet.records.len(),
            told: file.told.iter().cloned().chain(sheet.told).collect(),
        })
    }
}

/// The column that a heading is read as.
fn meant(cell: &str, names: &[String], vocabulary: Vocabulary, said: &Reading) -> Option<String> {
    if let Some(to) = said.of(cell) {
        return Some(reading::said(cell, to, vocabulary).ok()?.map_or("-".into(), |own| own.whole(vocabulary)));
    }
    let own = worded::heading(cell, vocabulary, names).ok()?;
    own.is_known.then(|| own.whole(vocabulary))
}

/// What no longer has room in a cell is left out.
fn cut(cell: &str) -> String {
    cell.chars().take(WIDEST).collect()
}
