//! Points from a table: CSV with a column for each input, and one for the files of measurements.

use std::path::{Path, PathBuf};

use super::design::{Input, Spread};
use super::quantity::no_quantity;
use crate::input::{InputError, Problem, Source, line_at, name_and_unit, no_csv, number, parted_by_commas};
use crate::model::Model;

/// Largest table, bytes.
pub const LARGEST: u64 = 1_000_000_000;
/// Column of the files of measurements.
const DATA: &str = "data";

/// Points that a table lists.
pub struct Table {
    /// An input for each column.
    pub inputs: Vec<Input>,
    /// Values in the units of the inputs, row by row.
    pub values: Vec<f64>,
    /// Number of rows.
    pub rows: u64,
    /// File of measurements of each row, if the table names them.
    pub files: Vec<PathBuf>,
}

/// A column of the table.
enum Column {
    /// An input, with the factor and offset of the column's unit.
    Input(f64, f64),
    Data,
}

/// Reads a table. `given` are the inputs of the plan itself, of which a table has none.
///
/// # Errors
/// The table is wrong; the error names the line.
pub fn read(source: &Source, model: &Model, given: Vec<Input>, folder: &Path) -> Result<Table, InputError> {
    let text = &source.text;
    let refuse =
        |problem: Problem, byte: usize| InputError::one(source.clone(), problem.at(Some(line_at(text, byte, 0))));
    if !given.is_empty() {
        let problem = Problem::new("the table says what varies, and the plan has an [[input]] too");
        return Err(refuse(problem.help("remove the [[input]], or the table"), 0));
    }
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|e| refuse(no_csv(&e, 0), 0))?.clone();
    parted_by_commas(header.iter()).map_err(|problem| refuse(problem, 0))?;
    let (mut inputs, mut columns) = (Vec::<Input>::new(), Vec::new());
    for cell in &header {
        let (name, unit) = name_and_unit(cell);
        if name == DATA {
            columns.push(Column::Data);
            continue;
        }
        let Some(known) = model.quantity(name) else {
            let (message, help) = no_quantity(model, name);
            return Err(refuse(Problem::new(message).help(help), 0));
        };
        if inputs.iter().any(|input| input.path == name) {
            return Err(refuse(Problem::new(format!("two columns are `{name}`")).help("keep one of them"), 0));
        }
        let unit = known.kind.unit_of(unit).map_err(|e| {
            let problem = Problem::new(format!("`{name}`: {}", e.message));
            refuse(problem.help(e.hint.unwrap_or_else(|| format!("head it `{name} [{}]`", known.kind.unit))), 0)
        })?;
        columns.push(Column::Input(unit.factor, unit.offset));
        let (path, kind, bounds) = (known.path.clone(), known.kind, known.bounds);
        inputs.push(Input { path, kind, bounds, spread: Spread::Table });
    }
    let (mut values, mut rows, mut files) = (Vec::new(), 0, Vec::new());
    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).map_err(|e| refuse(no_csv(&e, 0), 0))? {
        let byte = record.position().map_or(0, |position| position.byte() as usize);
        rows += 1;
        let mut of_row = inputs.iter();
        for ((column, cell), head) in columns.iter().zip(&record).zip(&header) {
            match column {
                Column::Data if cell.is_empty() => {
                    let problem = Problem::new("the row names no file of measurements");
                    return Err(refuse(problem.help("every row of a table with `data` names one"), byte));
                }
                Column::Data => files.push(folder.join(cell)),
                Column::Input(factor, offset) => {
                    let value = number(cell, head).map_err(|problem| refuse(problem, byte))?;
                    values.extend(of_row.next().map(|input| input.rounded(value * factor + offset)));
                }
            }
        }
    }
    if rows == 0 {
        return Err(refuse(Problem::new("the table has no rows").help("add at least one"), 0));
    }
    Ok(Table { inputs, values, rows, files })
}

/// The different files, and the position of that of each row.
pub fn distinct(files: Vec<PathBuf>) -> (Vec<PathBuf>, Vec<usize>) {
    let mut all = files.clone();
    all.sort();
    all.dedup();
    let positions = files.iter().map(|file| all.partition_point(|other| other < file)).collect();
    (all, positions)
}
