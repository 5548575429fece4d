//! A file in the program's own form: headings `name [unit]`, numbers with a point, a row for every observation.

use std::collections::BTreeMap;
use std::ops::Range;

use super::actual::Difference;
use super::decimal::{self, Decimal};
use super::exported::Exported;
use super::heading::{self, Heading};
use super::reading::{self, Reading};
use super::records::{Records, Refused};
use super::sheet::{Parted, Sheet};
use super::vocabulary::Vocabulary;
use super::{actual, clock, footer, header, header_rows, spelled, stacked, wide, worded, words};
use crate::input::{Problem, did_you_mean};
use crate::process::{Holds, Words};
use crate::units::{TIME, plain_unit};

/// Most readings of one sort that are told one by one.
const MOST_TOLD: usize = 8;

/// The cells of a file, as the program writes them.
#[derive(Debug)]
pub struct Table {
    /// Cells of the header.
    pub header: Vec<String>,
    /// Cells of the header, as the file writes them.
    pub headings: Vec<String>,
    /// Bytes of the header's line in the source.
    pub place: Range<usize>,
    /// Records; of a wide file several stand in one line.
    pub records: Records,
    /// What is wrong with single records.
    pub refused: Refused,
    /// The column that is a difference of two of the file's, if one is.
    pub difference: Option<Difference>,
    /// Notes for the user on everything that was read otherwise than it is written.
    pub notes: Vec<String>,
}

/// Reads a file in any of the forms that instruments and spreadsheets write.
///
/// # Errors
/// Problems of the header, and those without which nothing else can be read.
pub fn read(file: &Exported, vocabulary: Vocabulary, said: &Reading) -> Result<Table, Vec<Problem>> {
    let read = read_as(file, vocabulary, said);
    match said.kept_as_said() {
        // A line of headings that is kept holds of files that are not understood without it.
        Some(kept) if read.is_err() => read_as(file, vocabulary, &kept).or(read),
        _ => read,
    }
}

fn read_as(file: &Exported, vocabulary: Vocabulary, said: &Reading) -> Result<Table, Vec<Problem>> {
    let mut told = file.told.clone();
    let mut sheet = file.sheet(said).map_err(|problem| vec![problem])?;
    header_rows::settle(&mut sheet, vocabulary, said);
    let place = sheet.place.clone();
    let of_header = |problem: Problem| problem.at(Some(place.clone()));
    told.append(&mut sheet.told);
    let mut notes = Vec::new();
    let mut headings = headings(&mut sheet, vocabulary, said)
        .map_err(|problems| problems.into_iter().map(of_header).collect::<Vec<_>>())?;
    if !sheet.is_headed && headings.iter().all(|heading| !heading.is_known) {
        return Err(vec![of_header(unnamed(&sheet, vocabulary))]);
    }
    units(&mut headings, &mut sheet, &mut told).map_err(|problem| vec![problem])?;
    told.extend(footer::left_out(&mut sheet.records));
    by_words(&mut headings, &sheet.records, vocabulary);
    if let Some(time) = headings.iter().position(|heading| is_time(heading, vocabulary)) {
        told.extend(clock::with_dates(&mut headings, &mut sheet.records, time));
    }
    let numeric: Vec<bool> = headings.iter().map(|heading| is_numeric(heading, vocabulary)).collect();
    let mut refused = Refused { problems: sheet.problems, ..Refused::default() };
    let kept = said.kept.as_ref().and_then(|kept| kept.decimal);
    let marks = match file.parted {
        // What was said was of texts, and numbers are numbers.
        Parted::Workbook => (said.decimal.or(kept).map(|_| Decimal::Point), None),
        _ => (said.decimal, kept),
    };
    spelled::minus_in_front(&mut sheet.records, &numeric, &file.source.text, &mut told);
    let marks = decimal::settle(&mut sheet.records, &numeric, sheet.separator, marks, &mut told);
    refused.add(marks.map_err(|problem| vec![problem])?);
    spelled::degrees(&mut headings, &mut sheet.records, &numeric, &mut told);
    for (column, heading) in headings.iter_mut().enumerate().filter(|(_, heading)| is_time(heading, vocabulary)) {
        refused.add(clock::count(&mut sheet.records, column, heading, &mut notes));
    }
    told.extend(bounded(headings.iter().filter_map(|heading| heading.note(vocabulary)).collect()));
    let (headings, records) = stacked::stacked(headings, sheet.records, vocabulary, &mut told);
    let long = wide::lengthened(headings, records, vocabulary, &mut told);
    let (mut headings, mut records) = long.map_err(|problem| vec![of_header(problem)])?;
    let difference = actual::less_commanded(&mut headings, &mut records, vocabulary, &mut told)
        .map_err(|problem| vec![of_header(problem)])?;
    for (column, heading) in headings.iter().enumerate() {
        told.extend(bounded(settle_words(&mut records, column, heading, vocabulary)));
    }
    if !told.is_empty() {
        notes.insert(0, format!("how it was read: {}", told.join("; ")));
    }
    let header = headings.iter().map(Heading::cell).collect();
    Ok(Table { header, headings: sheet.header, place: sheet.place, records, refused, notes, difference })
}

/// Reads all headings, those that the user has said before those that speak for themselves, and drops columns
/// that are to be left out or are empty.
fn headings(sheet: &mut Sheet, vocabulary: Vocabulary, said: &Reading) -> Result<Vec<Heading>, Vec<Problem>> {
    let mut problems: Vec<Problem> = Vec::new();
    for from in said.names() {
        let mut meant = sheet.header.iter().filter(|cell| reading::is_meant(from, cell));
        let problem = match (meant.next(), meant.next()) {
            (Some(_), None) => continue,
            (Some(_), Some(_)) => Problem::new(format!("--columns: `{from}` names several columns"))
                .help("write the whole heading, with its unit"),
            (None, _) if said.is_of_several => continue,
            (None, _) => {
                let near = did_you_mean(from, sheet.header.iter().map(String::as_str), '`');
                let help = format!("{near}its columns are {}", sheet.header.join(", "));
                Problem::new(format!("--columns: there is no column `{from}`")).help(help)
            }
        };
        problems.push(problem);
    }
    let (mut headings, mut kept) = (Vec::new(), Vec::new());
    for (column, cell) in sheet.header.iter().enumerate() {
        if cell.is_empty() && is_empty(&sheet.records, column) {
            continue;
        }
        // A decimal comma in a place stands beside another separator only.
        let spelled = if sheet.separator == ',' { cell.clone() } else { cell.replace(',', ".") };
        let read = match said.of(cell) {
            Some(to) => reading::said(cell, to, vocabulary),
            None if cell.contains('@') => worded::heading(&spelled, vocabulary, &sheet.header).map(Some),
            None => worded::heading(cell, vocabulary, &names(&sheet.header)).map(Some),
        };
        match read {
            Ok(Some(heading)) => {
                headings.push(heading);
                kept.push(column);
            }
            Ok(None) => {}
            Err(problem) => problems.push(problem),
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    if kept.len() < sheet.header.len() {
        sheet.records.keep(&kept);
    }
    Ok(headings)
}

/// The problem of a file without headings of which nobody has said what its columns are.
fn unnamed(sheet: &Sheet, vocabulary: Vocabulary) -> Problem {
    let first = sheet.records.get(0);
    let cells: Vec<&str> = first.iter().collect();
    let message = format!("the file has no headings, and begins with {}", cells.join(" | "));
    let columns = header::needed(vocabulary);
    let said: Vec<String> = columns.iter().zip(1..).map(|(column, number)| format!("{number}={column}")).collect();
    Problem::new(message).help(format!(
        "say what its columns are, by their numbers: --columns '{}'; `fem effects {}` lists all names",
        said.join(","),
        vocabulary.process
    ))
}

fn is_empty(records: &Records, column: usize) -> bool {
    let mut reader = records.reader();
    (0..records.len()).all(|record| reader.read(record)[column].is_empty())
}

/// Names of the columns as the file writes them, without units.
fn names(header: &[String]) -> Vec<String> {
    header.iter().map(|cell| crate::input::name_and_unit(cell).0.to_string()).collect()
}

/// Takes the units of columns that have none from a first record that holds nothing but units.
fn units(headings: &mut [Heading], sheet: &mut Sheet, told: &mut Vec<String>) -> Result<(), Problem> {
    if sheet.records.is_empty() {
        return Ok(());
    }
    let first = sheet.records.get(0);
    let cells: Vec<&str> = first.iter().map(heading::bare_unit).collect();
    let is_unit = |cell: &&str| heading::is_unit(cell);
    let is_blank = |cell: &str| matches!(cell, "" | "-");
    let known = || headings.iter().zip(&cells).filter(|(heading, _)| heading.is_known);
    if !known().all(|(_, cell)| is_blank(cell) || is_unit(cell)) || !known().any(|(_, cell)| is_unit(cell)) {
        return Ok(());
    }
    for (heading, cell) in headings.iter_mut().zip(&cells).filter(|(heading, cell)| heading.is_known && is_unit(cell)) {
        let cell = plain_unit(cell);
        if !heading.unit.is_empty() && heading.unit != cell {
            let message = format!("`{}` is in {} by its heading, and in {cell} here", heading.name, heading.unit);
            return Err(Problem::new(message).help("keep one of the units").at(Some(sheet.records.place(0))));
        }
        heading.unit = cell;
        // The unit stands elsewhere; the name alone may be as the program writes it.
        if heading.written == heading.name {
            heading.written = heading.cell();
        }
    }
    told.push(format!("units from line {}", sheet.records.line(0)));
    sheet.records.leave_first_out();
    Ok(())
}

/// Takes a column of whatever name that holds nothing but words of a coordinate which no other column is for that coordinate.
fn by_words(headings: &mut [Heading], records: &Records, vocabulary: Vocabulary) {
    let of = |column: usize, all: &Words| {
        let mut reader = records.reader();
        // Numbers mean many things.
        let mut is_spelled = false;
        for record in 0..records.len() {
            let cell = &reader.read(record)[column];
            if !cell.is_empty() && words::meant(cell, all).is_none() {
                return false;
            }
            is_spelled |= !cell.is_empty() && cell.parse::<f64>().is_err();
        }
        is_spelled
    };
    let taken: Vec<String> = headings.iter().filter(|own| own.is_known).map(|own| own.name.clone()).collect();
    let absent = vocabulary.coordinates.iter().filter(|own| !taken.iter().any(|name| *own.name == **name));
    for coordinate in absent {
        let Holds::Word(all) = &coordinate.holds else { continue };
        let unknown =
            headings.iter_mut().enumerate().filter(|(_, heading)| !heading.is_known && heading.unit.is_empty());
        let mut meant = unknown.filter(|(column, _)| of(*column, all));
        if let (Some((_, heading)), None) = (meant.next(), meant.next()) {
            (heading.name, heading.is_known) = (coordinate.name.to_string(), true);
        }
    }
}

fn is_numeric(heading: &Heading, vocabulary: Vocabulary) -> bool {
    let is_word = vocabulary.coordinate(&heading.name).is_some_and(|c| matches!(c.holds, Holds::Word(_)));
    heading.is_known && !is_word
}

fn is_time(heading: &Heading, vocabulary: Vocabulary) -> bool {
    let kind = vocabulary.coordinate(&heading.name).and_then(|c| c.holds.kind());
    heading.is_known && kind.is_some_and(|kind| kind.canonical().dimension == TIME.canonical().dimension)
}

/// Writes the words of a column as the program does, and tells which were written otherwise.
fn settle_words(records: &mut Records, column: usize, heading: &Heading, vocabulary: Vocabulary) -> Vec<String> {
    let holds = vocabulary.coordinate(&heading.name).filter(|_| heading.is_known).map(|c| &c.holds);
    let Some(Holds::Word(all)) = holds else { return Vec::new() };
    let mut told = BTreeMap::new();
    records.rewrite(&[column], |_, cells, column| {
        let cell = &cells[column];
        let word = words::meant(cell, all).filter(|word| *word != cell)?;
        told.entry(cell.to_string()).or_insert(word);
        Some(word.to_string())
    });
    told.into_iter().map(|(cell, word)| format!("{} `{cell}` as {word}", heading.name)).collect()
}

/// The first of several readings, and how many more there are.
fn bounded(mut all: Vec<String>) -> Vec<String> {
    let more = all.len().saturating_sub(MOST_TOLD);
    all.truncate(MOST_TOLD);
    if more > 0 {
        all.push(format!("{more} more of these"));
    }
    all
}
