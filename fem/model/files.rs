//! How the measurement files of a machine are read: the table `[data]`.

use super::entry::Edit;
use crate::input::{InputError, Raw, Reader, Source};
use crate::measure::{Decimal, Reading};

/// The table.
pub const DATA: &str = "data";

const MARKS: &[(&str, Decimal)] = &[("comma", Decimal::Comma), ("point", Decimal::Point)];

/// Reads the table of a model.
pub fn read(model: &Reader) -> Reading {
    let about = "how measurement files are read where they do not say it themselves; `fem import --keep` writes it";
    model.optional_table(DATA, about, of_table).unwrap_or_default()
}

/// The same of a model that is parsed and not read yet.
///
/// # Errors
/// The table is wrong.
pub fn of_document(source: &Source, document: &toml_edit::Table) -> Result<Reading, InputError> {
    let Some(table) = document.get(DATA).and_then(|item| item.as_table_like()) else { return Ok(Reading::default()) };
    let (reading, _, problems) = Reader::document(table, of_table);
    if problems.is_empty() { Ok(reading) } else { Err(InputError::new(source.clone(), problems)) }
}

/// The edit that keeps in a model how its files are read, with what it kept before.
pub fn kept(reading: &Reading) -> Edit {
    let mut keys: Vec<(&str, String)> = Vec::new();
    let whole = reading.with_kept();
    let columns: Vec<String> = whole.columns().iter().map(|(from, to)| format!("{from}={to}")).collect();
    if !columns.is_empty() {
        keys.push(("columns", columns.join(",")));
    }
    let mark = whole.decimal.and_then(|mark| MARKS.iter().find(|(_, own)| *own == mark));
    keys.extend(mark.map(|(word, _)| ("decimal", word.to_string())));
    keys.extend(whole.headings.map(|line| ("header", line.unwrap_or(0).to_string())));
    keys.extend(whole.sheet.map(|name| ("sheet", name)));
    let value = Raw::of_keys(keys.iter().map(|(key, text)| (*key, &**text)));
    Edit::Write { path: DATA.into(), value }
}

fn of_table(table: &Reader) -> Reading {
    let columns =
        table.text("columns", "what columns are, as `--columns` says it: Zeit=time [s],T1=temperature@x=12 mm");
    let decimal = table.choice("decimal", "the decimal mark, where a file could mean either", MARKS).optional();
    let header = table
        .count("header", "the line in which the headings stand; 0 where there are none")
        .between(0, 1000)
        .optional();
    let sheet = table.text("sheet", "the sheet of a workbook");
    let headings = header.map(|line| (line > 0).then_some(line));
    let reading = Reading::new(columns.as_slice(), decimal).unwrap_or_else(|problem| {
        let message = problem.message.trim_start_matches("--columns ").to_string();
        table.problem("columns", message, problem.help.unwrap_or_default());
        Reading::default()
    });
    reading.within(headings, sheet)
}
