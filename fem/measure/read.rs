//! Reads the rows of a measurement file.

use std::path::Path;

use csv::StringRecord;

use super::alike::Alike;
use super::exported::{self, Exported};
use super::header::{self, Column, Header};
use super::reading::Reading;
use super::recorded::{self, Recorded};
use super::records::Records;
use super::table;
use super::vocabulary::{MeasuredObservable, Purpose, Vocabulary};
use super::{MeasuredFile, Measurements, Ordinals};
use crate::input::{InputError, Problem, Source, number};
use crate::process::{Absent, Holds, Process, Rows, Values};
use crate::units::{ANGLE, FEED_RATE, FORCE, Kind, LENGTH, TEMPERATURE, TIME, Unit};

impl Measurements {
    /// Reads a file of measurements of `process`.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn load(path: &Path, process: &dyn Process) -> Result<Self, InputError> {
        Self::load_as(path, process, &Reading::default())
    }

    /// Reads a file of measurements of which the user has said how it is to be read.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn load_as(path: &Path, process: &dyn Process, said: &Reading) -> Result<Self, InputError> {
        read(&exported::open(path, said)?, process, Purpose::Measured, said)
    }

    /// Reads measurements of a process from a file that is open already.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn of_file(file: &Exported, process: &dyn Process, said: &Reading) -> Result<Self, InputError> {
        read(file, process, Purpose::Measured, said)
    }

    /// Reads a design, a file of planned rows in which nothing need have been observed yet.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn load_design(path: &Path, process: &dyn Process, said: &Reading) -> Result<Self, InputError> {
        read(&exported::open(path, said)?, process, Purpose::Design, said)
    }

    /// Reads a design from the text of a file.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn parse_design(source: Source, process: &dyn Process, said: &Reading) -> Result<Self, InputError> {
        read(&exported::of_text(source)?, process, Purpose::Design, said)
    }

    /// Reads measurements from the text of a file.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn parse(source: Source, process: &dyn Process) -> Result<Self, InputError> {
        Self::parse_as(source, process, &Reading::default())
    }

    /// Reads measurements from the text of a file of which the user has said how it is to be read.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its line.
    pub fn parse_as(source: Source, process: &dyn Process, said: &Reading) -> Result<Self, InputError> {
        read(&exported::of_text(source)?, process, Purpose::Measured, said)
    }
}

fn read(file: &Exported, process: &dyn Process, purpose: Purpose, said: &Reading) -> Result<Measurements, InputError> {
    let source = file.source.clone();
    let vocabulary = Vocabulary::of(process);
    let refuse = |problems| InputError::new(source.clone(), problems);
    let file = table::read(file, vocabulary, said).map_err(refuse)?;
    let of_header = |problem: Problem| problem.at(Some(file.place.clone()));
    let header = header::read(&file.header, vocabulary, purpose)
        .map_err(|problems| refuse(problems.into_iter().map(of_header).collect()))?;
    let (beside, unused) = recorded::read(&header, &file.header, &file.records);
    let mut builder = Builder::new((&header, &beside), vocabulary, purpose, file.header, file.records.len());
    let mut alike = Alike::default();
    let mut reader = file.records.reader();
    for (number, line) in file.records.lines().enumerate() {
        // What is wrong with a row is told once.
        if !file.refused.records.contains(&file.records.byte(number)) {
            let taken = builder.push(number, line, reader.read(number));
            taken.unwrap_or_else(|problem| alike.push(problem, Some(file.records.place(number))));
        }
    }
    drop(reader);
    let mut problems = file.refused.problems;
    problems.extend(alike.problems());
    if problems.is_empty() && builder.measurements.observed.is_empty() {
        let help = match builder.left_out.is_empty() {
            true => "add at least one observation",
            false => "every row has an empty cell where the observed value should stand",
        };
        problems.push(Problem::new("the file has a header and no rows").help(help));
    }
    if !problems.is_empty() {
        return Err(refuse(problems));
    }
    if let Some(problem) = builder.far_out() {
        return Err(refuse(vec![of_header(problem)]));
    }
    let left_out = unobserved(&builder.left_out);
    let mut measurements = builder.measurements;
    measurements.name = source.name.to_string();
    measurements.records = file.records;
    measurements.files = vec![MeasuredFile { name: source.name.to_string(), first_record: 0, sha256: source.sha256 }];
    (measurements.headings, measurements.said) = (file.headings, said.options());
    measurements.notes = file.notes.into_iter().chain(left_out).chain(measurements.notes).chain(unused).collect();
    measurements.leave_echoes_out();
    if !said.as_typed && purpose == Purpose::Measured {
        measurements = measurements.without_slips(vocabulary, &header.columns, file.difference).without_own_copies();
    }
    if measurements.len() > MANY {
        let rows = measurements.len();
        measurements
            .notes
            .push(format!("{rows} rows may take more than a gigabyte of memory; every tenth would tell as much"));
    }
    if measurements.observables.is_empty() {
        measurements.observables = MeasuredObservable::of(&measurements.rows, vocabulary.observables);
    }
    Ok(measurements)
}

/// Rows above which a note tells what they may take: each some 80 bytes with two coordinates, 170 with eight.
const MANY: usize = 6_000_000;

/// Where coordinates of a kind end, SI: more than any machine, part or test has.
const FARTHEST: &[(Kind, f64)] =
    &[(ANGLE, 1e6), (LENGTH, 1e7), (TIME, 1e10), (FORCE, 1e10), (TEMPERATURE, 1e5), (FEED_RATE, 1e5)];

/// Most lines that a note lists.
const MOST_LINES: usize = 10;

/// The note of the rows in which nothing was observed, by their lines.
fn unobserved(lines: &[u64]) -> Option<String> {
    let mut distinct = lines.to_vec();
    distinct.dedup();
    let listed: Vec<String> = distinct.iter().take(MOST_LINES).map(u64::to_string).collect();
    let more = if distinct.len() > MOST_LINES { ", …" } else { "" };
    let rows = if lines.len() == 1 { "row is" } else { "rows are" };
    let where_ = if distinct.len() == 1 { "line" } else { "lines" };
    let told = || {
        let count = lines.len();
        format!("{count} {rows} left out, for nothing was observed: {where_} {}{more}", listed.join(", "))
    };
    (!lines.is_empty()).then(told)
}

struct Builder<'a> {
    header: &'a Header,
    beside: &'a [Recorded],
    vocabulary: Vocabulary<'a>,
    purpose: Purpose,
    measurements: Measurements,
    /// Lines of the rows in which nothing was observed.
    left_out: Vec<u64>,
}

impl<'a> Builder<'a> {
    fn new(
        (header, beside): (&'a Header, &'a [Recorded]),
        vocabulary: Vocabulary<'a>,
        purpose: Purpose,
        cells: Vec<String>,
        rows: usize,
    ) -> Self {
        let has_u = header.columns.iter().any(|c| matches!(c, Column::Uncertainty(..)));
        let given = header.columns.iter().filter_map(|c| match c {
            Column::Coordinate(i, _) => Some(*i),
            _ => None,
        });
        let measurements = Measurements {
            name: String::new(),
            files: Vec::new(),
            rows: Rows {
                columns: vec![Values::with_capacity(rows); vocabulary.coordinates.len() + beside.len()],
                observable: Values::with_capacity(rows),
            },
            observed: Vec::with_capacity(rows),
            uncertainty: has_u.then(|| Values::with_capacity(rows)),
            records_of: Ordinals::default(),
            lines: Ordinals::default(),
            observables: header.observables.clone(),
            given: given.chain((0..beside.len()).map(|i| vocabulary.coordinates.len() + i)).collect(),
            recorded: beside.iter().map(|own| own.coordinate.clone()).collect(),
            header: cells,
            headings: Vec::new(),
            said: Vec::new(),
            records: Records::default(),
            notes: header.notes.clone(),
        };
        Self { header, beside, vocabulary, purpose, measurements, left_out: Vec::new() }
    }

    /// Takes a record whole, or reports its problem and takes nothing. A record in which nothing was observed
    /// is counted and left out.
    fn push(&mut self, number: usize, line: u64, record: &StringRecord) -> Result<(), Problem> {
        let observed = self.observed(record)?;
        if observed.is_empty() {
            self.left_out.push(line);
            return Ok(());
        }
        let coordinates = self.coordinates(record, &observed)?;
        let table = &mut self.measurements;
        for o in observed {
            for ((column, value), coordinate) in
                table.rows.columns.iter_mut().zip(&coordinates).zip(self.vocabulary.coordinates)
            {
                let elsewhere = coordinate.absent.only_of().is_some_and(|own| !own.contains(&o.observable));
                column.push(if elsewhere { f64::NAN } else { *value });
            }
            let own = self.vocabulary.coordinates.len();
            for (column, beside) in table.rows.columns[own..].iter_mut().zip(self.beside) {
                column.push(beside.values[number]);
            }
            table.rows.observable.push(o.observable);
            table.observed.push(o.value);
            if let Some(all) = &mut table.uncertainty {
                all.push(o.uncertainty);
            }
            table.records_of.push(number);
            table.lines.push(line as usize);
        }
        Ok(())
    }

    /// The problem of a coordinate that reaches where no machine and no test does.
    fn far_out(&self) -> Option<Problem> {
        let table = &self.measurements;
        self.vocabulary.coordinates.iter().zip(&table.rows.columns).enumerate().find_map(|(i, (own, values))| {
            let kind = own.holds.kind().filter(|_| table.given.contains(&i))?;
            let most = FARTHEST.iter().find(|(of, _)| of.canonical().dimension == kind.canonical().dimension)?.1;
            let largest = values.iter().fold(0.0f64, |most, v| if v.abs() > most { v.abs() } else { most });
            let told = || {
                let (name, reached) = (&own.name, kind.format(largest));
                Problem::new(format!("`{name}` goes up to {reached}: is its unit right?"))
                    .help(format!("write the unit that it has: {name} [{}]", kind.unit))
            };
            (largest > most).then(told)
        })
    }

    /// Reads the observed values of a record; empty cells observe nothing. A design asks for none.
    fn observed(&self, record: &StringRecord) -> Result<Vec<Observed>, Problem> {
        let cells = || record.iter().zip(&self.header.columns).zip(&self.measurements.header);
        let mut all = Vec::new();
        for ((cell, column), name) in cells() {
            if let Column::Observed(observable, unit) = column
                && !cell.is_empty()
            {
                let value = number(cell, name)? * unit.factor + unit.offset;
                all.push(Observed { observable: *observable, value, uncertainty: f64::NAN });
            }
        }
        if self.purpose == Purpose::Design && all.is_empty() {
            all.push(Observed { observable: self.planned(record), value: 0.0, uncertainty: f64::NAN });
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
    fn planned(&self, record: &StringRecord) -> usize {
        let needs = |(cell, column): (&str, &Column)| match column {
            Column::Coordinate(i, _) if !cell.is_empty() => {
                self.vocabulary.coordinates[*i].absent.only_of().map(|own| *own.start())
            }
            _ => None,
        };
        record.iter().zip(&self.header.columns).find_map(needs).unwrap_or(0)
    }

    /// Reads the coordinates of a record. A coordinate of an observable that the record does not observe may
    /// be empty.
    fn coordinates(&self, record: &StringRecord, observed: &[Observed]) -> Result<Vec<f64>, Problem> {
        let mut coordinates: Vec<f64> = self.vocabulary.coordinates.iter().map(left_out).collect();
        for ((cell, column), name) in record.iter().zip(&self.header.columns).zip(&self.measurements.header) {
            let Column::Coordinate(i, unit) = column else { continue };
            let coordinate = &self.vocabulary.coordinates[*i];
            let own = coordinate.absent.only_of();
            let idle = own.is_some_and(|own| observed.iter().all(|o| !own.contains(&o.observable)));
            if idle && cell.is_empty() {
                continue;
            }
            coordinates[*i] = match (&coordinate.holds, unit) {
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
        Absent::Refused | Absent::Model | Absent::NeededBy(..) | Absent::NeededBut(_) | Absent::ModelOf(..) => f64::NAN,
    }
}

fn label(cell: &str, column: &str, holds: &Holds) -> Result<f64, Problem> {
    match holds {
        Holds::Word(words) => words.position(cell).map(|i| i as f64).ok_or_else(|| {
            Problem::new(format!("`{cell}` in `{column}` is no {column}"))
                .help(format!("it is one of {}", words.iter().collect::<Vec<_>>().join(", ")))
        }),
        Holds::Number(least) => {
            let value = number(cell, column)?;
            if value.fract() == 0.0 && value >= f64::from(*least) {
                Ok(value)
            } else {
                Err(Problem::new(format!("`{column}` is {cell}")).help(format!("it is a whole number from {least}")))
            }
        }
        Holds::Quantity(_) => number(cell, column),
    }
}
