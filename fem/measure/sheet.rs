//! The cells of a file as an instrument or a spreadsheet wrote them: separators, byte order mark, comments,
//! and the line in which every record stands.

use std::ops::Range;

use csv::StringRecord;

use super::records::{LARGEST_TEXT, Records, csv_builder};
use crate::input::{Problem, Source, line_at, no_csv};

/// Number of problems after which reading stops.
pub const MOST_PROBLEMS: usize = 20;

/// Most columns of a file: more are lines that were joined.
const MOST_COLUMNS: usize = 1000;

/// Separators of columns, in the order in which they are tried: a decimal comma may stand beside the first two.
const SEPARATORS: [char; 3] = [';', '\t', ','];

/// Header and records of a file.
#[derive(Debug)]
pub struct Sheet {
    /// Separator of the columns.
    pub separator: char,
    /// Cells of the header, as written.
    pub header: Vec<String>,
    /// Bytes of the header's line.
    pub place: Range<usize>,
    /// Records in their order.
    pub records: Records,
    /// Records that cannot be read.
    pub problems: Vec<Problem>,
    /// How the file was read where it is not written as the program writes its own.
    pub told: Vec<String>,
}

/// Reads the cells of a file.
///
/// # Errors
/// The header cannot be read as CSV.
pub fn read(source: &Source) -> Result<Sheet, Problem> {
    let whole = &source.text;
    let text = whole.strip_prefix('\u{feff}').unwrap_or(whole);
    let (said, text) = said_separator(text);
    let skipped = whole.len() - text.len();
    let separator = said.unwrap_or_else(|| separator(text));
    if whole.len() > LARGEST_TEXT {
        return Err(Problem::new("the file has more than 4 GB of text").help("part it, and name its parts"));
    }
    let mut reader = csv_builder(separator as u8).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|error| no_csv(&error, skipped))?.clone();
    if header.len() > MOST_COLUMNS {
        let problem = Problem::new(format!("the header has {} columns; at most {MOST_COLUMNS} are read", header.len()));
        return Err(problem.help("has the file lost its line ends? leave out columns that are not needed"));
    }
    let byte = |record: &StringRecord| record.position().map_or(0, |position| position.byte() as usize);
    let mut sheet = Sheet {
        separator,
        place: line_at(text, byte(&header), skipped),
        records: Records::of_file(whole.clone(), separator as u8, header.len()),
        header: header.iter().map(str::to_string).collect(),
        problems: Vec::new(),
        told: separator_notes(separator),
    };
    let mut record = StringRecord::new();
    loop {
        match reader.read_record(&mut record) {
            Ok(false) => break,
            Ok(true) => sheet.records.push(skipped + byte(&record)),
            Err(error) => sheet.problems.push(ragged(&error, skipped, separator)),
        }
        if sheet.problems.len() >= MOST_PROBLEMS {
            break;
        }
    }
    Ok(sheet)
}

/// The problem of a record that is no CSV, or has other cells than the header.
fn ragged(error: &csv::Error, skipped: usize, separator: char) -> Problem {
    let problem = no_csv(error, skipped);
    match error.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } if separator == ',' && len > expected_len => problem
            .help("give every row one cell per column; where decimals have a comma, part the columns by semicolons"),
        _ => problem,
    }
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

/// The separator that stands in the header as often as in the record below it; else the most frequent one of
/// the header.
fn separator(text: &str) -> char {
    let mut lines = text.lines().filter(|line| !line.trim().is_empty() && !line.starts_with('#'));
    let (header, first) = (lines.next().unwrap_or_default(), lines.next().unwrap_or_default());
    let fits = |separator: &char| {
        let count = count(header, *separator);
        count > 0 && count == self::count(first, *separator)
    };
    let frequent = || SEPARATORS.into_iter().rev().max_by_key(|separator| count(header, *separator));
    SEPARATORS.into_iter().find(fits).or_else(frequent).unwrap_or(',')
}

/// Times a character stands in a line outside of quotes.
fn count(line: &str, wanted: char) -> usize {
    let mut quoted = false;
    let is_wanted = |c: &char| {
        quoted ^= *c == '"';
        *c == wanted && !quoted
    };
    line.chars().filter(is_wanted).count()
}

/// Note on a separator other than the program's own.
fn separator_notes(separator: char) -> Vec<String> {
    match separator {
        ';' => vec!["columns parted by semicolons".into()],
        '\t' => vec!["columns parted by tabs".into()],
        _ => Vec::new(),
    }
}
