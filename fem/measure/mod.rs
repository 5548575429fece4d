//! Measurement files: one observation per row, with its coordinates, its value and perhaps its uncertainty.

mod header;
mod read;
mod repeats;

pub use repeats::{Repeats, Scatter, repeats};

use std::borrow::Cow;
use std::path::Path;

use crate::input::{InputError, Source};
use crate::process::{Blind, Coordinate, Observable, Process, Rows, System};
use crate::units::Kind;

/// Largest measurement file, bytes: some ten million rows.
const LARGEST: u64 = 500_000_000;

/// An observable of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// Its position in the process's list.
    pub position: usize,
    /// Its name.
    pub name: &'static str,
    /// Its kind, with the unit in which results tell of errors in it.
    pub kind: Kind,
    /// The unit in which it is written.
    pub unit: String,
}

/// Measurements of a process.
#[derive(Clone, Debug)]
pub struct Measurements {
    /// The file's name.
    pub name: String,
    /// Where and how each row was observed.
    pub rows: Rows,
    /// What was observed, SI.
    pub observed: Vec<f64>,
    /// Standard uncertainty of each row, SI; `None` without a column `u`.
    pub uncertainty: Option<Vec<f64>>,
    /// The record, from 0, that each row stands in; a record that holds several observables gives a row for each.
    pub records_of: Vec<usize>,
    /// Line of the file of each row.
    pub lines: Vec<u64>,
    /// The observables of the file, in the order of their columns; never none.
    pub seen: Vec<Seen>,
    /// Which coordinates the file has a column for, by their position in the process's list.
    pub given: Vec<usize>,
    /// The file's header and records, as written.
    pub header: Vec<String>,
    /// As written.
    pub records: Vec<csv::StringRecord>,
    /// What the reader should know: columns that were not used.
    pub notes: Vec<String>,
    /// Directions that were taken out of the observed values, because the way of measuring is blind to them.
    pub blind: Vec<Blind>,
}

impl Measurements {
    /// Reads a file of measurements of `process`.
    ///
    /// # Errors
    /// Everything that is wrong with it, with lines.
    pub fn load(path: &Path, process: &dyn Process) -> Result<Self, InputError> {
        Self::parse(Source::read(path, LARGEST)?, process)
    }

    /// Reads a file of rows that are planned: the same, but nothing need have been observed yet.
    ///
    /// # Errors
    /// Everything that is wrong with it, with lines.
    pub fn load_design(path: &Path, process: &dyn Process) -> Result<Self, InputError> {
        read::read(Source::read(path, LARGEST)?, process, Purpose::Design)
    }

    /// Rows of a process, with nothing observed yet.
    pub fn planned(process: &dyn Process, name: &str, rows: Rows) -> Self {
        Self {
            name: name.into(),
            observed: vec![0.0; rows.len()],
            uncertainty: None,
            records_of: (0..rows.len()).collect(),
            lines: (0..rows.len() as u64).collect(),
            seen: Seen::of(&rows, process.observables()),
            given: (0..process.coordinates().len()).collect(),
            header: Vec::new(),
            records: Vec::new(),
            notes: Vec::new(),
            blind: Vec::new(),
            rows,
        }
    }

    /// Reads measurements from the text of a file.
    ///
    /// # Errors
    /// Everything that is wrong with it, with lines.
    pub fn parse(source: Source, process: &dyn Process) -> Result<Self, InputError> {
        read::read(source, process, Purpose::Measured)
    }

    /// A number that tells what was observed from anything else (Fowler, Noll and Vo's hash, 1a).
    pub fn digest(&self) -> u64 {
        let bytes = self.observed.iter().flat_map(|y| y.to_bits().to_le_bytes());
        bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    }

    /// The rows that `keep` chooses by their number, as a file of their own.
    #[must_use]
    pub fn some(&self, keep: impl Fn(usize) -> bool) -> Self {
        let rows: Vec<usize> = (0..self.len()).filter(|row| keep(*row)).collect();
        let of = |column: &Vec<f64>| rows.iter().map(|r| column[*r]).collect::<Vec<f64>>();
        Self {
            rows: Rows {
                columns: self.rows.columns.iter().map(of).collect(),
                observable: rows.iter().map(|r| self.rows.observable[*r]).collect(),
            },
            observed: of(&self.observed),
            uncertainty: self.uncertainty.as_ref().map(of),
            records_of: rows.iter().map(|r| self.records_of[*r]).collect(),
            lines: rows.iter().map(|r| self.lines[*r]).collect(),
            records: Vec::new(),
            name: self.name.clone(),
            seen: self.seen.clone(),
            given: self.given.clone(),
            header: self.header.clone(),
            notes: self.notes.clone(),
            // Of fewer rows they are others: a system sees them anew.
            blind: Vec::new(),
        }
    }

    /// The rows of one of its observables, as a file of their own.
    #[must_use]
    pub fn of(&self, seen: &Seen) -> Self {
        let rows = self.some(|row| self.rows.observable[row] == seen.position);
        Self { seen: vec![seen.clone()], ..rows }
    }

    /// In what errors over all rows are told: the observable's kind, or standard uncertainties where there are several observables.
    pub fn kind(&self) -> Kind {
        match &self.seen[..] {
            [one] => one.kind,
            _ => Kind { name: "a standard uncertainty", unit: "sigma", usual: "1" },
        }
    }

    /// Errors (SI) of all rows as they are told together: as they are, or in standard uncertainties where there are several observables.
    pub fn together(&self, errors: &[f64], sigma: &[f64]) -> Vec<f64> {
        match &self.seen[..] {
            [_] => errors.to_vec(),
            _ => errors.iter().zip(sigma).map(|(e, s)| e / s).collect(),
        }
    }

    /// The number, among the file's observables, of the one that a row observes.
    pub fn observable(&self, row: usize) -> usize {
        self.seen.iter().position(|s| s.position == self.rows.observable[row]).unwrap_or(0)
    }

    /// The rows of each of its observables.
    pub fn rows_by_observable(&self) -> Vec<Vec<usize>> {
        let own = |s: &Seen| (0..self.len()).filter(|row| self.rows.observable[*row] == s.position).collect();
        self.seen.iter().map(own).collect()
    }

    /// As a system sees them: without what its way of measuring is blind to.
    pub fn seen_by<'a>(&'a self, system: &dyn System) -> Cow<'a, Self> {
        let blind = system.blind(&self.rows);
        if blind.is_empty() {
            return Cow::Borrowed(self);
        }
        let mut seen = self.clone();
        blind.iter().for_each(|direction| direction.take_out(&mut seen.observed));
        seen.blind = blind;
        Cow::Owned(seen)
    }

    /// Degrees of freedom: observations less directions to which the way of measuring is blind.
    pub fn freedom(&self) -> f64 {
        (self.len() - self.blind.len()) as f64
    }

    /// Number of observations.
    pub fn len(&self) -> usize {
        self.observed.len()
    }

    /// Whether there are none; a file without rows is refused, so never.
    pub fn is_empty(&self) -> bool {
        self.observed.is_empty()
    }
}

impl Seen {
    /// The observables of rows.
    fn of(rows: &Rows, observables: &[Observable]) -> Vec<Self> {
        let seen = observables.iter().enumerate().filter(|(i, _)| rows.observable.contains(i));
        seen.map(|(i, o)| Self::new(i, o, o.kind.unit)).collect()
    }

    fn new(position: usize, observable: &Observable, unit: &str) -> Self {
        Self { position, name: observable.name, kind: observable.error_kind(), unit: unit.to_string() }
    }
}

/// What a file is read for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Purpose {
    /// What was measured.
    Measured,
    /// What will be.
    Design,
}

/// What a process can be measured by.
#[derive(Clone, Copy)]
struct Vocabulary {
    observables: &'static [Observable],
    coordinates: &'static [Coordinate],
}
