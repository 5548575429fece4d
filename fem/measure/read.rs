//! Reads the rows of a measurement file.

use std::path::Path;

use super::Measurements;
use super::header::{self, Column, Header};
use super::vocabulary::{MeasuredObservable, Purpose, Vocabulary};
use crate::input::{InputError, Problem, Source, line_at, no_csv, number};
use crate::process::{Absent, Holds, Process, Rows};
use crate::units::Unit;

/// Largest measurement file, bytes: some ten million rows.
const LARGEST_FILE: u64 = 500_000_000;

impl Measurements {
    /// Reads a file of measurements of `process`.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn load(path: &Path, process: &dyn Process) -> Result<Self, InputError> {
        Self::parse(Source::read(path, LARGEST_FILE)?, process)
    }

    /// Reads a design, a file of planned rows in which nothing need have been observed yet.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn load_design(path: &Path, process: &dyn Process) -> Result<Self, InputError> {
        read(Source::read(path, LARGEST_FILE)?, process, Purpose::Design)
    }

    /// Reads measurements from the text of a file.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn parse(source: Source, process: &dyn Process) -> Result<Self, InputError> {
        read(source, process, Purpose::Measured)
    }
}

/// Number of problems after which reading stops.
const MOST_PROBLEMS: usize = 20;

pub fn read(source: Source, process: &dyn Process, purpose: Purpose) -> Result<Measurements, InputError> {
    let vocabulary = Vocabulary { observables: process.observables(), coordinates: process.coordinates() };
    let text = source.text.strip_prefix('\u{feff}').unwrap_or(&source.text);
    let skipped = source.text.len() - text.len();
    let refuse = |problems| InputError::new(source.clone(), problems);
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let cells: Vec<String> = match reader.headers() {
        Ok(headers) => headers.iter().map(str::to_string).collect(),
        Err(error) => return Err(refuse(vec![no_csv(&error, skipped)])),
    };
    let place = reader.headers().ok().and_then(|h| h.position()).map(|p| line_at(text, p.byte() as usize, skipped));
    let header = header::read(&cells, vocabulary, purpose)
        .map_err(|problems| refuse(problems.into_iter().map(|p| p.at(place.clone())).collect()))?;
    let mut table = Builder::new(&header, vocabulary, cells);
    let mut problems = Vec::new();
    for record in reader.records() {
        match record {
            Ok(record) => {
                let span = record.position().map(|p| line_at(text, p.byte() as usize, skipped));
                table.push(record).unwrap_or_else(|problem| problems.push(problem.at(span)));
            }
            Err(error) => problems.push(no_csv(&error, skipped)),
        }
        if problems.len() >= MOST_PROBLEMS {
            break;
        }
    }
    if problems.is_empty() && table.measurements.observed.is_empty() {
        problems.push(Problem::new("the file has a header and no rows").help("add at least one observation"));
    }
    if !problems.is_empty() {
        return Err(refuse(problems));
    }
    let mut measurements = table.measurements;
    measurements.name = source.name.to_string();
    if measurements.observables.is_empty() {
        measurements.observables = MeasuredObservable::of(&measurements.rows, vocabulary.observables);
    }
    Ok(measurements)
}

struct Builder<'a> {
    header: &'a Header,
    vocabulary: Vocabulary,
    measurements: Measurements,
}

impl<'a> Builder<'a> {
    fn new(header: &'a Header, vocabulary: Vocabulary, cells: Vec<String>) -> Self {
        let has_u = header.columns.iter().any(|c| matches!(c, Column::Uncertainty(..)));
        let given = header.columns.iter().filter_map(|c| match c {
            Column::Coordinate(i, _) => Some(*i),
            _ => None,
        });
        let measurements = Measurements {
            name: String::new(),
            rows: Rows { columns: vec![Vec::new(); vocabulary.coordinates.len()], observable: Vec::new() },
            observed: Vec::new(),
            uncertainty: has_u.then(Vec::new),
            records_of: Vec::new(),
            lines: Vec::new(),
            observables: header.observables.clone(),
            given: given.collect(),
            header: cells,
            records: Vec::new(),
            notes: header.notes.clone(),
        };
        Self { header, vocabulary, measurements }
    }

    /// Takes a record whole, or reports its problem and takes nothing.
    fn push(&mut self, record: csv::StringRecord) -> Result<(), Problem> {
        let observed = self.observed(&record)?;
        let coordinates = self.coordinates(&record, &observed)?;
        let table = &mut self.measurements;
        for o in observed {
            for ((column, value), coordinate) in
                table.rows.columns.iter_mut().zip(&coordinates).zip(self.vocabulary.coordinates)
            {
                let elsewhere = coordinate.absent.only_of().is_some_and(|own| own != o.observable);
                column.push(if elsewhere { f64::NAN } else { *value });
            }
            table.rows.observable.push(o.observable);
            table.observed.push(o.value);
            if let Some(all) = &mut table.uncertainty {
                all.push(o.uncertainty);
            }
            table.records_of.push(table.records.len());
            table.lines.push(record.position().map_or(0, csv::Position::line));
        }
        table.records.push(record);
        Ok(())
    }

    /// Reads the observed values of a record. Where there are several observables some cells may be empty,
    /// but not all.
    fn observed(&self, record: &csv::StringRecord) -> Result<Vec<Observed>, Problem> {
        let cells = || record.iter().zip(&self.header.columns).zip(&self.measurements.header);
        let may_be_empty = self.header.observables.len() > 1;
        let mut all = Vec::new();
        for ((cell, column), name) in cells() {
            if let Column::Observed(observable, unit) = column
                && !(may_be_empty && cell.is_empty())
            {
                let value = number(cell, name)? * unit.factor + unit.offset;
                all.push(Observed { observable: *observable, value, uncertainty: f64::NAN });
            }
        }
        if self.header.observables.is_empty() {
            all.push(Observed { observable: self.planned(record), value: 0.0, uncertainty: f64::NAN });
        }
        if all.is_empty() {
            return Err(Problem::new("the row observes nothing").help("fill in one of its observables"));
        }
        for ((cell, column), name) in cells() {
            if let Column::Uncertainty(of, unit) = column
                && let Some(observed) = all.iter_mut().find(|o| of.is_none_or(|of| of == o.observable))
            {
                observed.uncertainty = uncertainty(cell, name, *unit)?;
            }
        }
        Ok(all)
    }

    /// Infers the observable of a row of a design that does not name it: the one that needs the coordinates
    /// that are given, else the first.
    fn planned(&self, record: &csv::StringRecord) -> usize {
        let needs = |(cell, column): (&str, &Column)| match column {
            Column::Coordinate(i, _) if !cell.is_empty() => self.vocabulary.coordinates[*i].absent.only_of(),
            _ => None,
        };
        record.iter().zip(&self.header.columns).find_map(needs).unwrap_or(0)
    }

    /// Reads the coordinates of a record. A coordinate of an observable that the record does not observe may
    /// be empty.
    fn coordinates(&self, record: &csv::StringRecord, observed: &[Observed]) -> Result<Vec<f64>, Problem> {
        let mut coordinates: Vec<f64> = self.vocabulary.coordinates.iter().map(left_out).collect();
        for ((cell, column), name) in record.iter().zip(&self.header.columns).zip(&self.measurements.header) {
            let Column::Coordinate(i, unit) = column else { continue };
            let coordinate = &self.vocabulary.coordinates[*i];
            let own = coordinate.absent.only_of();
            let idle = own.is_some_and(|own| observed.iter().all(|o| o.observable != own));
            if idle && cell.is_empty() {
                continue;
            }
            coordinates[*i] = match (coordinate.holds, unit) {
                (Holds::Quantity(_), Some(unit)) => number(cell, name)? * unit.factor + unit.offset,
                (holds, _) => label(cell, name, holds)?,
            };
        }
        Ok(coordinates)
    }
}

/// Observed value and standard uncertainty of one observable in a record, SI; the uncertainty is NaN where
/// no column has it.
struct Observed {
    observable: usize,
    value: f64,
    uncertainty: f64,
}

/// Standard uncertainties (SI) that any instrument can have: from the size of a proton, below which χ² of
/// the worst rows would overflow, to far beyond any reading.
const SMALLEST: f64 = 1e-15;
const LARGEST: f64 = 1e9;

fn uncertainty(cell: &str, name: &str, unit: Unit) -> Result<f64, Problem> {
    let value = number(cell, name)? * unit.factor;
    if value <= 0.0 {
        let problem = Problem::new(format!("`{}` is {cell}", name.split(['[', ' ']).next().unwrap_or("u")));
        return Err(problem.help("a standard uncertainty is above zero; leave the column out if it is not known"));
    }
    if !(SMALLEST..=LARGEST).contains(&value) {
        let problem = Problem::new(format!("`{name}` is {cell}"));
        return Err(problem.help("no uncertainty is so small or so large: is the unit right?"));
    }
    Ok(value)
}

fn left_out(coordinate: &crate::process::Coordinate) -> f64 {
    match coordinate.absent {
        Absent::Value(value) => value,
        Absent::Refused | Absent::Model | Absent::NeededBy(_) | Absent::ModelOf(_) => f64::NAN,
    }
}

fn label(cell: &str, column: &str, holds: Holds) -> Result<f64, Problem> {
    match holds {
        Holds::Word(words) => words.iter().position(|w| *w == cell).map(|i| i as f64).ok_or_else(|| {
            Problem::new(format!("`{cell}` in `{column}` is no {column}"))
                .help(format!("it is one of {}", words.join(", ")))
        }),
        Holds::Number(least) => {
            let value = number(cell, column)?;
            if value.fract() == 0.0 && value >= f64::from(least) {
                Ok(value)
            } else {
                Err(Problem::new(format!("`{column}` is {cell}")).help(format!("it is a whole number from {least}")))
            }
        }
        Holds::Quantity(_) => number(cell, column),
    }
}
