//! Workbooks of spreadsheets, `.xlsx`, `.xlsm`, `.xlsb`, `.xls` and `.ods`: one of their sheets as text, a line for each row.

use std::io::Cursor;

use calamine::{
    Data, DataType, ExcelDateTime, Ods, Reader, SheetVisible, Sheets, Xls, Xlsb, Xlsx, open_workbook_from_rs,
};

use super::decimal::{self, Decimal};
use super::layout;
use super::reading::Reading;
use crate::input::Problem;

/// Most columns that are read; more are cells that stand far off.
const MOST_COLUMNS: usize = 1000;

/// Largest workbook, bytes when unpacked, as its directory says.
const LARGEST: u64 = 1_000_000_000;

/// Largest text of a sheet, bytes.
const LARGEST_SHEET: usize = 500_000_000;

/// Rows with numbers by which the first sheet that holds measurements is known.
const ROWS_OF_A_TABLE: usize = 4;

/// What begins a workbook: a zip archive, or a compound file.
const ZIP: &[u8] = b"PK\x03\x04";
const COMPOUND: &[u8] = b"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1";

type Book<'b> = Sheets<Cursor<&'b [u8]>>;

/// The text of a sheet, tabs between its cells; `None` where the bytes are no workbook. `said` may name the sheet; else it is
/// the first that holds a table, or whatever holds most of one. The names of all go into `sheets`.
///
/// # Errors
/// The workbook cannot be read, is too large, or has no such sheet.
pub fn text(
    bytes: &[u8],
    said: &Reading,
    told: &mut Vec<String>,
    sheets: &mut Vec<String>,
) -> Option<Result<String, Problem>> {
    (bytes.starts_with(ZIP) || bytes.starts_with(COMPOUND)).then(|| {
        let mut book = open(bytes)?;
        // Those that nobody sees are looked at last.
        let (seen, hidden): (Vec<_>, Vec<_>) =
            book.sheets_metadata().iter().partition(|sheet| sheet.visible == SheetVisible::Visible);
        *sheets = seen.into_iter().chain(hidden).map(|sheet| sheet.name.clone()).collect();
        sheet(&mut book, sheets, said, told)
    })
}

fn sheet(book: &mut Book, names: &[String], said: &Reading, told: &mut Vec<String>) -> Result<String, Problem> {
    let marks = said.decimal.or(said.kept.as_ref().and_then(|kept| kept.decimal));
    let named = |name: &String| names.iter().find(|own| own.trim().eq_ignore_ascii_case(name.trim()));
    let kept = || said.kept.as_ref().and_then(|kept| named(kept.sheet.as_ref()?));
    if let Some(name) = said.sheet.as_ref().or_else(kept) {
        let Some(own) = named(name) else {
            let problem = Problem::new(format!("--sheet: the workbook has no sheet `{name}`"));
            return Err(problem.help(format!("its sheets are {}", names.join(", "))));
        };
        told.push(format!("the sheet `{own}`"));
        return written(book, own, marks);
    }
    let mut best: Option<(usize, &String, String)> = None;
    for name in names {
        let text = written(book, name, marks)?;
        let rows = layout::rows(&text, '\t');
        if rows > best.as_ref().map_or(0, |(most, ..)| *most) {
            best = Some((rows, name, text));
        }
        if rows >= ROWS_OF_A_TABLE {
            break;
        }
    }
    if let Some((_, name, text)) = best {
        if names.len() > 1 {
            let others: Vec<&str> = names.iter().filter(|own| *own != name).map(String::as_str).collect();
            told.push(format!("the sheet `{name}`, not {} (--sheet NAME reads another)", others.join(", ")));
        }
        return Ok(text);
    }
    let problem = Problem::new("no sheet of the workbook holds a table of numbers");
    Err(problem.help(format!("name the sheet with --sheet; they are {}", names.join(", "))))
}

fn open(bytes: &[u8]) -> Result<Book<'_>, Problem> {
    let wrong = |error: &dyn std::fmt::Display| {
        let problem = Problem::new(format!("the workbook cannot be read: {error}"));
        problem.help("save it anew as .xlsx without a password, or its sheet as CSV")
    };
    let file = || Cursor::new(bytes);
    if bytes.starts_with(COMPOUND) {
        return Ok(Sheets::Xls(open_workbook_from_rs::<Xls<_>, _>(file()).map_err(|error| wrong(&error))?));
    }
    let archive = zip::ZipArchive::new(file()).map_err(|error| wrong(&error))?;
    if archive.decompressed_size().is_none_or(|size| size > u128::from(LARGEST)) {
        let problem = Problem::new(format!("the workbook unpacks to more than {} MB", LARGEST / 1_000_000));
        return Err(problem.help("save the sheet of the measurements alone"));
    }
    let has = |name: &str| archive.index_for_name(name).is_some();
    if has("xl/workbook.bin") {
        Ok(Sheets::Xlsb(open_workbook_from_rs::<Xlsb<_>, _>(file()).map_err(|error| wrong(&error))?))
    } else if has("xl/workbook.xml") {
        Ok(Sheets::Xlsx(open_workbook_from_rs::<Xlsx<_>, _>(file()).map_err(|error| wrong(&error))?))
    } else if has("content.xml") {
        Ok(Sheets::Ods(open_workbook_from_rs::<Ods<_>, _>(file()).map_err(|error| wrong(&error))?))
    } else {
        let problem = Problem::new("this is an archive, and no workbook");
        Err(problem.help("unpack it, and name the file of the measurements"))
    }
}

/// The text of a sheet; numbers that are texts have the decimal mark that was said.
fn written(book: &mut Book, name: &str, marks: Option<Decimal>) -> Result<String, Problem> {
    let wrong = |error: &dyn std::fmt::Display| {
        let problem = Problem::new(format!("the sheet `{name}` cannot be read: {error}"));
        problem.help("save it anew as .xlsx, or as CSV")
    };
    let mut lines = Lines { marks, ..Lines::default() };
    match book {
        // Cell by cell, for one that stands far off would make a table of all that lies between.
        Sheets::Xlsx(book) => {
            let mut cells = book.worksheet_cells_reader(name).map_err(|error| wrong(&error))?;
            while let Some(cell) = cells.next_cell().map_err(|error| wrong(&error))? {
                lines.push(cell.get_position(), &Data::from(cell.get_value().clone()))?;
            }
        }
        book => {
            let range = book.worksheet_range(name).map_err(|error| wrong(&error))?;
            let (row, column) = range.start().unwrap_or_default();
            for (i, j, cell) in range.used_cells() {
                lines.push((row + i as u32, column + j as u32), cell)?;
            }
        }
    }
    Ok(lines.text)
}

/// Lines of a sheet as they come, row after row.
#[derive(Default)]
struct Lines {
    /// The decimal mark of numbers that are texts.
    marks: Option<Decimal>,
    text: String,
    row: u32,
    column: u32,
}

impl Lines {
    fn push(&mut self, (row, column): (u32, u32), cell: &Data) -> Result<(), Problem> {
        if cell.is_empty() {
            return Ok(());
        }
        if column as usize >= MOST_COLUMNS || self.text.len() > LARGEST_SHEET {
            let message = format!("the sheet has a cell in row {} and column {}: too far off", row + 1, column + 1);
            return Err(Problem::new(message).help("delete what stands beside the table"));
        }
        // Rows without cells are blank lines, so that the number of a line is that of its row.
        while self.row < row {
            self.text.push('\n');
            (self.row, self.column) = (self.row + 1, 0);
        }
        while self.column < column {
            self.text.push('\t');
            self.column += 1;
        }
        self.text.push_str(&shown(cell, self.marks));
        Ok(())
    }
}

/// A cell as a table of text would have it.
fn shown(cell: &Data, marks: Option<Decimal>) -> String {
    match cell {
        Data::Empty => String::new(),
        // Fifteen digits are what spreadsheets keep; more are round-off of their sums.
        Data::Float(number) => format!("{number:.14e}").parse::<f64>().unwrap_or(*number).to_string(),
        Data::Int(number) => number.to_string(),
        Data::Bool(value) => value.to_string(),
        Data::DateTime(moment) => moment_of(moment),
        Data::DateTimeIso(text) | Data::DurationIso(text) => quoted(text),
        // A line that begins with # would be a comment.
        Data::Error(error) => format!("error {error}"),
        Data::String(text) => decimal::of_text(text.trim(), marks).unwrap_or_else(|| quoted(text)),
    }
}

/// A text on one line, in quotes where it needs them.
fn quoted(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if line.starts_with('#') || line.contains('"') { format!("\"{}\"", line.replace('"', "\"\"")) } else { line }
}

/// A date with its time, a time of day alone, or a duration, of which the hours go on beyond a day.
fn moment_of(moment: &ExcelDateTime) -> String {
    let days = moment.as_f64();
    if moment.is_duration() && days >= 1.0 {
        let thousandths = (days * 86_400e3).round() as u64;
        let (seconds, rest) = (thousandths / 1000, thousandths % 1000);
        let fraction = if rest > 0 { format!(".{rest:03}") } else { String::new() };
        return format!("{:02}:{:02}:{:02}{fraction}", seconds / 3600, seconds / 60 % 60, seconds % 60);
    }
    let (year, month, day, hours, minutes, seconds, thousandths) = moment.to_ymd_hms_milli();
    let fraction = if thousandths > 0 { format!(".{thousandths:03}") } else { String::new() };
    let time = format!("{hours:02}:{minutes:02}:{seconds:02}{fraction}");
    match moment.as_f64() < 1.0 || moment.is_duration() {
        true => time,
        false => format!("{year:04}-{month:02}-{day:02}T{time}"),
    }
}
