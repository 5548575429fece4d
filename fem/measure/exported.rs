//! Files as instruments, spreadsheets and laboratories export them, made into text with a line for each row.

use std::path::Path;

use super::instrument::{self, text_of_rtx};
use super::reading::Reading;
use super::sheet::{self, Parted, Sheet};
use super::{layout, lexicon, parquet, workbook};
use crate::input::{InputError, Problem, Source};

/// Largest measurement file, bytes: some ten million rows.
const LARGEST_FILE: u64 = 500_000_000;

/// A file as text, with what was made of it.
#[derive(Clone, Debug)]
pub struct Exported {
    /// The text.
    pub source: Source,
    /// How it was read where it is not text as the program writes it.
    pub told: Vec<String>,
    /// Who parted its columns.
    pub parted: Parted,
    /// Names of the sheets of a workbook.
    pub sheets: Vec<String>,
}

impl Exported {
    /// The cells of the table that it holds.
    ///
    /// # Errors
    /// It is no table.
    pub(super) fn sheet(&self, said: &Reading) -> Result<Sheet, Problem> {
        instrument::read(&self.source).unwrap_or_else(|| sheet::read(&self.source, self.parted, said.headings))
    }
}

/// Opens a file.
///
/// # Errors
/// It cannot be read, is too large, or is nothing that is known here.
pub fn open(path: &Path, said: &Reading) -> Result<Exported, InputError> {
    let mut told = Vec::new();
    let mut is_workbook = false;
    let mut sheets = Vec::new();
    let binary = |bytes: &[u8]| {
        let workbook = workbook::text(bytes, said, &mut told, &mut sheets).or_else(|| parquet::text(bytes));
        is_workbook = workbook.is_some();
        workbook.or_else(|| text_of_rtx(bytes))
    };
    let (source, encoding) = Source::read_exported(path, LARGEST_FILE, binary, lexicon::count)?;
    told.extend(encoding.map(|name| format!("text in {name}")));
    let exported = of_text(source)?;
    told.extend(exported.told);
    let parted = if is_workbook { Parted::Workbook } else { exported.parted };
    Ok(Exported { told, parted, sheets, ..exported })
}

/// Makes plain text of a text: line ends of old machines become those of today's, and columns that blanks part are parted
/// by tabs. Lines stay lines.
///
/// # Errors
/// A line is longer than that of any table.
pub fn of_text(source: Source) -> Result<Exported, InputError> {
    let Source { name, mut text, sha256 } = source;
    let mut told = Vec::new();
    if has_lone_returns(&text) {
        text = with_line_ends(&text).into();
    }
    // Cells take many times the memory of their text: what is no table is not parted.
    if let Some(problem) = layout::too_wide(&text) {
        return Err(InputError::one(Source { name, text, sha256 }, problem));
    }
    let parted = if instrument::find(&text).is_none() { layout::of_blanks(&text) } else { None };
    let by = if parted.is_some() { Parted::Blanks } else { Parted::File };
    if let Some(parted) = parted {
        told.push("columns parted by blanks".into());
        text = parted.into();
    }
    Ok(Exported { source: Source { name, text, sha256 }, told, parted: by, sheets: Vec::new() })
}

/// Whether a carriage return stands without a line feed behind it.
fn has_lone_returns(text: &str) -> bool {
    let bytes = text.as_bytes();
    bytes.iter().enumerate().any(|(i, byte)| *byte == b'\r' && bytes.get(i + 1) != Some(&b'\n'))
}

fn with_line_ends(text: &str) -> String {
    let mut written = String::with_capacity(text.len());
    for (i, piece) in text.split('\r').enumerate() {
        if i > 0 {
            written.push(if piece.starts_with('\n') { '\r' } else { '\n' });
        }
        written.push_str(piece);
    }
    written
}
