//! The cells of a file as an instrument or a spreadsheet wrote them: separators, byte order mark, comments,
//! and the line in which every record stands.

use std::ops::Range;

use csv::StringRecord;

use super::alike::Alike;
use super::heading;
use super::layout::{self, MOST_COLUMNS, SEPARATORS};
use super::records::{LARGEST_TEXT, Records, csv_builder};
use crate::input::{Problem, Source, line_at, no_csv};

/// Rows of other lengths after which nothing more is read.
const MOST_RAGGED: usize = 10_000;

/// Who parted the columns of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parted {
    /// The file.
    File,
    /// The program, where the file has blanks.
    Blanks,
    /// The program, for a sheet of a workbook: rows end with their last cell that has something.
    Workbook,
}

/// Header and records of a file.
#[derive(Debug)]
pub struct Sheet {
    /// Separator of the columns.
    pub separator: char,
    /// Cells of the header, as written; numbers of the columns, from 1, where the file has no headings.
    pub header: Vec<String>,
    /// Whether the file has headings.
    pub is_headed: bool,
    /// Bytes of the header's line, or of the first record's.
    pub place: Range<usize>,
    /// Records in their order.
    pub records: Records,
    /// Records that cannot be read.
    pub problems: Vec<Problem>,
    /// How the file was read where it is not written as the program writes its own.
    pub told: Vec<String>,
}

/// Reads the cells of a file. `headings` is the line in which its headings stand, where somebody has said it, or that it has
/// none.
///
/// # Errors
/// It is no table, or longer than can be read.
pub fn read(source: &Source, parted: Parted, headings: Option<Option<usize>>) -> Result<Sheet, Problem> {
    let whole = &source.text;
    let text = whole.strip_prefix('\u{feff}').unwrap_or(whole);
    let (said, text) = said_separator(text);
    let skipped = whole.len() - text.len();
    if whole.len() > LARGEST_TEXT {
        return Err(Problem::new("the file has more than 4 GB of text").help("part it, and name its parts"));
    }
    if let Some(Some(line)) =
        headings.filter(|line| line.is_some_and(|line| whole.lines().nth(line.saturating_sub(1)).is_none()))
    {
        let problem = Problem::new(format!(
            "the headings cannot stand in line {line}: there are {} lines",
            whole.lines().count()
        ));
        return Err(problem.help(
            "say the line, from 1, that has the names of the columns: --header LINE; --header 0 where none has",
        ));
    }
    // Lines that were taken off hold no heading.
    let headings = headings.map(|line| line.map(|own| own - whole[..skipped].matches('\n').count().min(own)));
    let layout = layout::find(text, said, headings);
    if layout.columns > MOST_COLUMNS {
        let problem =
            Problem::new(format!("the header has {} columns; at most {MOST_COLUMNS} are read", layout.columns));
        return Err(problem.help("has the file lost its line ends? leave out columns that are not needed"));
    }
    let separator = layout.separator;
    let (header, place) = match &layout.headings {
        Some(place) => (layout::cells(&text[place.clone()], separator), place.start + skipped..place.end + skipped),
        None => ((1..=layout.columns).map(|number| number.to_string()).collect(), line_at(text, layout.begin, skipped)),
    };
    let mut told: Vec<String> = match separator {
        _ if parted != Parted::File => Vec::new(),
        ';' => vec!["columns parted by semicolons".into()],
        '\t' => vec!["columns parted by tabs".into()],
        _ => Vec::new(),
    };
    if layout.above > 0 {
        let lines = if layout.above == 1 { "line" } else { "lines" };
        told.push(format!("{} {lines} above the table left out", layout.above));
    }
    let columns = header.len();
    let mut sheet = Sheet {
        separator,
        place,
        records: Records::of_file(whole.clone(), separator as u8, columns),
        is_headed: layout.headings.is_some(),
        header,
        problems: Vec::new(),
        told,
    };
    let (begin, rest) = (layout.begin + skipped, &text[layout.begin..]);
    let mut reader = csv_builder(separator as u8).has_headers(false).flexible(true).from_reader(rest.as_bytes());
    let byte = |record: &StringRecord| record.position().map_or(0, |position| position.byte() as usize);
    let mut record = StringRecord::new();
    let mut ragged = Vec::new();
    loop {
        match reader.read_record(&mut record) {
            Ok(false) => break,
            // Spreadsheets part empty cells behind the last that has something.
            Ok(true)
                if record.len() == columns
                    || is_padded(&record, &sheet.header)
                    || (parted == Parted::Workbook && !is_prose(&record, columns)) =>
            {
                sheet.records.push(begin + byte(&record));
            }
            Ok(true) if is_rule(&record) => {}
            Ok(true) => {
                let problem = uneven(&record, columns, separator).at(Some(line_at(rest, byte(&record), begin)));
                let is_text = record.iter().find(|cell| !cell.is_empty()).is_some_and(|cell| !layout::is_value(cell));
                ragged.push((problem, is_text));
            }
            Err(error) => ragged.push((no_csv(&error, begin), false)),
        }
        if ragged.len() >= MOST_RAGGED {
            break;
        }
    }
    sheet.below(&mut ragged);
    let mut problems = Alike::default();
    ragged.into_iter().for_each(|(problem, _)| problems.push(problem, None));
    sheet.problems = problems.problems();
    Ok(sheet)
}

impl Sheet {
    /// Leaves out what instruments write below a table: rows of other lengths behind the last of its own that begin with
    /// words. One that begins with a number may be cut off, and is wrong.
    fn below(&mut self, ragged: &mut Vec<(Problem, bool)>) {
        let last = self.records.len().checked_sub(1).map_or(0, |last| self.records.place(last).end);
        let is_below = |problem: &Problem| problem.span.as_ref().is_some_and(|span| span.start >= last);
        let begins =
            ragged.iter().rposition(|(problem, is_text)| !is_text || !is_below(problem)).map_or(0, |at| at + 1);
        let Some(first) = ragged.get(begins).and_then(|(problem, _)| problem.span.clone()) else { return };
        let line = 1 + self.records.text()[..first.start].matches('\n').count();
        self.told.push(format!("what stands below the table left out, from line {line} on"));
        ragged.truncate(begins);
    }
}

/// Whether a record is shorter than the header and holds words alone, as what stands below a table.
fn is_prose(record: &StringRecord, columns: usize) -> bool {
    record.len() > columns
        || record.iter().all(|cell| cell.is_empty() || !layout::is_value(cell) && !heading::is_unit(cell))
}

/// Whether a record draws a line.
fn is_rule(record: &StringRecord) -> bool {
    let is_stroke = |c: char| matches!(c, '-' | '=' | '_' | '+' | '|' | '*');
    record.iter().any(|cell| cell.len() > 1) && record.iter().all(|cell| cell.chars().all(is_stroke))
}

/// Whether a record has as many cells as the header but for empty ones at the end of either.
fn is_padded(record: &StringRecord, header: &[String]) -> bool {
    let behind = record.iter().skip(header.len());
    let unnamed = header.iter().skip(record.len());
    behind.chain(unnamed.map(|cell| &**cell)).all(str::is_empty)
}

/// The problem of a record that has other cells than the header.
fn uneven(record: &StringRecord, columns: usize, separator: char) -> Problem {
    let problem = Problem::new(format!("the row has {} cells, the header {columns}", record.len()));
    problem.help(match separator == ',' && record.len() > columns {
        true => "give every row one cell per column; where decimals have a comma, part the columns by semicolons",
        false => "give every row one cell per column",
    })
}

/// The separator that a first line `sep=;` names, and the text behind that line: so write spreadsheets.
fn said_separator(text: &str) -> (Option<char>, &str) {
    let line = text.lines().next().unwrap_or_default();
    let said = line.trim_matches('"').strip_prefix("sep=").and_then(|rest| rest.chars().next());
    match said.filter(|said| SEPARATORS.contains(said)) {
        Some(said) => (Some(said), text[line.len()..].trim_start_matches('\r').trim_start_matches('\n')),
        None => (None, text),
    }
}
