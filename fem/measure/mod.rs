//! Measurement files: one observation per row, with its coordinates, its value and perhaps its uncertainty.

mod actual;
mod alike;
mod clock;
mod copies;
mod decimal;
mod exported;
mod footer;
mod grid;
mod header;
mod header_rows;
mod heading;
mod instrument;
mod join;
mod layout;
mod lexicon;
mod moment;
mod neighbours;
mod ordinals;
mod parquet;
mod preview;
mod read;
mod reading;
mod recorded;
mod records;
mod repeats;
mod sheet;
mod slips;
mod spelled;
mod stacked;
mod table;
mod thin;
mod vocabulary;
mod wide;
mod worded;
mod words;
mod workbook;

pub use decimal::Decimal;
pub use exported::{Exported, open};
pub use grid::step_of;
pub use join::{FILE, FILE_WORD, MeasuredFile, grouping_name};
pub use neighbours::of_neighbours;
pub use ordinals::Ordinals;
#[cfg(all(test, feature = "parquet"))]
pub use parquet::text as text_of_parquet;
pub use preview::{Imported, Preview};
pub use reading::Reading;
pub use records::{RecordReader, Records};
pub use repeats::{LEAST_FREEDOM, LEAST_NEIGHBOURS, Repeats, Scatter, repeats};
pub use vocabulary::{MeasuredObservable, is_column};

use std::borrow::Cow;

use rayon::prelude::*;

use crate::input::name_and_unit;
use crate::process::{Coordinate, Process, Rows, Values};
use crate::units::Kind;

/// Measurements of a process.
#[derive(Clone, Debug)]
pub struct Measurements {
    /// Name of the file, or of all of them.
    pub name: String,
    /// Files, in their order; there is at least one.
    #[doc(hidden)]
    pub files: Vec<MeasuredFile>,
    /// Coordinates and observable of each row.
    #[doc(hidden)]
    pub rows: Rows,
    /// Observed values, SI.
    pub observed: Vec<f64>,
    /// Standard uncertainty of each row, SI; `None` without a column `u`.
    #[doc(hidden)]
    pub uncertainty: Option<Values>,
    /// Record, from 0, in which each row stands; a record that holds several observables gives a row for
    /// each.
    #[doc(hidden)]
    pub records_of: Ordinals,
    /// Line of the file in which each row stands.
    #[doc(hidden)]
    pub lines: Ordinals,
    /// Observables of the file, in the order of their columns; there is at least one.
    #[doc(hidden)]
    pub observables: Vec<MeasuredObservable>,
    /// Coordinates that have a column in the file, by their position in the process's list.
    pub given: Vec<usize>,
    /// Columns that the files have beside the coordinates of the process, after these among the columns of the rows.
    #[doc(hidden)]
    pub recorded: Vec<Coordinate>,
    /// Cells of the header, in the program's form.
    pub header: Vec<String>,
    /// Cells of the header, as the file writes them.
    pub headings: Vec<String>,
    /// Options by which the user has said how the file is to be read.
    pub said: Vec<String>,
    /// Records, in the program's form; none where they are not to be written again.
    #[doc(hidden)]
    pub records: Records,
    /// Notes for the user: how a file was read, and columns that are not used.
    pub notes: Vec<String>,
}

/// Parts levels by a further key; they are numbered from 0 as they first appear.
fn parted(mut levels: Vec<usize>, key: impl Fn(usize) -> u64 + Sync) -> Vec<usize> {
    // Most keys are the same in every row.
    if (1..levels.len()).all(|row| key(row) == key(0)) {
        return levels;
    }
    // Sorted, for a table of a million levels would be ten times as large.
    let mut order: Vec<u32> = (0..levels.len() as u32).collect();
    let whole = |row: u32| (levels[row as usize], key(row as usize));
    order.par_sort_unstable_by_key(|row| (whole(*row), *row));
    let mut first = vec![0; levels.len()];
    for alike in order.chunk_by(|a, b| whole(*a) == whole(*b)) {
        alike.iter().for_each(|row| first[*row as usize] = alike[0]);
    }
    drop(order);
    let mut numbers = 0..;
    for row in 0..levels.len() {
        let first = first[row] as usize;
        levels[row] = if first == row { numbers.next().unwrap_or(0) } else { levels[first] };
    }
    levels
}

impl Measurements {
    /// Makes a design of rows of a process, with nothing observed yet.
    #[doc(hidden)]
    pub fn planned(process: &dyn Process, name: &str, rows: Rows) -> Self {
        Self {
            name: name.into(),
            files: vec![MeasuredFile { name: name.into(), first_record: 0, sha256: None }],
            observed: vec![0.0; rows.len()],
            uncertainty: None,
            records_of: (0..rows.len()).collect(),
            lines: (0..rows.len()).collect(),
            observables: MeasuredObservable::of(&rows, process.observables()),
            given: (0..process.coordinates().len().min(rows.columns.len())).collect(),
            recorded: Vec::new(),
            header: Vec::new(),
            headings: Vec::new(),
            said: Vec::new(),
            records: Records::default(),
            notes: Vec::new(),
            rows,
        }
    }

    /// Hash of observed values (FNV-1a: Fowler, Noll and Vo), by which they are recognised.
    pub fn digest(observed: &[f64]) -> u64 {
        let bytes = observed.iter().flat_map(|y| y.to_bits().to_le_bytes());
        bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    }

    /// Selects the rows whose numbers `keep` accepts, as a file of their own.
    #[must_use]
    pub fn some(&self, keep: impl Fn(usize) -> bool) -> Self {
        let rows: Vec<usize> = (0..self.len()).filter(|row| keep(*row)).collect();
        let ordinals = |all: &Ordinals| rows.iter().filter_map(|row| all.get(*row)).collect();
        Self {
            rows: self.rows.some(&rows),
            observed: rows.iter().map(|row| self.observed[*row]).collect(),
            uncertainty: self.uncertainty.as_ref().map(|all| all.some(&rows)),
            records_of: ordinals(&self.records_of),
            lines: ordinals(&self.lines),
            records: Records::default(),
            name: self.name.clone(),
            files: self.files.clone(),
            observables: self.observables.clone(),
            given: self.given.clone(),
            recorded: self.recorded.clone(),
            header: self.header.clone(),
            headings: self.headings.clone(),
            said: self.said.clone(),
            notes: self.notes.clone(),
        }
    }

    /// The same rows but for those that `keep` does not accept; the text stays whole.
    #[must_use]
    fn keeping(mut self, keep: impl Fn(usize) -> bool) -> Self {
        let records = std::mem::take(&mut self.records);
        Self { records, ..self.some(keep) }
    }

    /// The same without the text in which they stand, for those who will not write it again: of long files it is half of
    /// what they take in memory.
    #[must_use]
    pub fn without_records(self) -> Self {
        Self { records: Records::default(), ..self }
    }

    /// Selects the rows of one observable, as a file of their own.
    #[must_use]
    #[doc(hidden)]
    pub fn of(&self, seen: &MeasuredObservable) -> Self {
        let rows = self.some(|row| self.rows.observable[row] == seen.position);
        Self { observables: vec![seen.clone()], ..rows }
    }

    /// Kind in which errors of all rows are given together: that of the observable, or standard
    /// uncertainties where there are several observables.
    pub fn kind(&self) -> Kind {
        match &self.observables[..] {
            [one] => one.kind,
            _ => Kind::new("a standard uncertainty", "sigma", "1"),
        }
    }

    /// Errors (SI) of all rows on one scale: unchanged for one observable, divided by `sigma` where there
    /// are several.
    #[doc(hidden)]
    pub fn together<'a>(&self, errors: &'a [f64], sigma: &Values) -> Cow<'a, [f64]> {
        match &self.observables[..] {
            [_] => errors.into(),
            _ => errors.iter().zip(sigma.iter()).map(|(e, s)| e / s).collect(),
        }
    }

    /// Whether all readings of each observable are one number, to the last digit: nothing was measured, or nothing is seen of
    /// what the rows differ in.
    pub fn are_all_alike(&self) -> bool {
        /// What directions that were taken out leave of such readings, SI: less than the size of a proton.
        const ROUND_OFF: f64 = 1e-15;
        let is_one = |rows: Vec<usize>| {
            let mut all = rows.iter().map(|row| self.observed[*row]);
            all.next().is_none_or(|first| all.all(|own| (own - first).abs() <= ROUND_OFF))
        };
        self.len() > 1 && self.rows_by_observable().into_iter().all(is_one)
    }

    /// Number, among the file's observables, of the one that a row observes.
    pub fn observable(&self, row: usize) -> usize {
        self.observables.iter().position(|s| s.position == self.rows.observable[row]).unwrap_or(0)
    }

    /// Observed less predicted values of all rows, SI.
    pub fn residuals(&self, predicted: &[f64]) -> Vec<f64> {
        self.observed.iter().zip(predicted).map(|(y, p)| y - p).collect()
    }

    /// Level of each row by some coordinates, or the [`FILE`], together, numbered from 0 as they first appear.
    pub fn levels(&self, by: &[usize]) -> Vec<usize> {
        by.iter().fold(vec![0; self.len()], |levels, i| parted(levels, |row| self.level(*i, row)))
    }

    /// The same, each observable by itself. A file is no place: what its rows repeat of another's they repeat, whichever way
    /// the rows were put into files, and a zero of its own is sought among the effects of the measurement.
    fn levels_of_observables(&self, by: &[usize]) -> Vec<usize> {
        parted(self.levels(by), |row| self.rows.observable[row] as u64)
    }

    /// Value of a coordinate, or number of the file, as a key.
    fn level(&self, by: usize, row: usize) -> u64 {
        self.rows.columns.get(by).map_or(self.file_number(row) as u64, |column| column[row].to_bits())
    }

    /// Row numbers of each observable.
    pub fn rows_by_observable(&self) -> Vec<Vec<usize>> {
        let own =
            |s: &MeasuredObservable| (0..self.len()).filter(|row| self.rows.observable[*row] == s.position).collect();
        self.observables.iter().map(own).collect()
    }

    /// Whether nothing was observed yet: the file has no column of any observable.
    pub fn is_planned(&self) -> bool {
        let is_of = |cell: &String| self.observables.iter().any(|o| name_and_unit(cell).0 == o.name);
        !self.header.iter().any(is_of)
    }

    /// Line of the file in which a row stands.
    pub fn line(&self, row: usize) -> u64 {
        self.lines.get(row).unwrap_or(0) as u64
    }

    /// Record of a row, counted from 1 as people do.
    pub fn record(&self, row: usize) -> usize {
        1 + self.records_of.get(row).unwrap_or(0)
    }

    /// Number of observations.
    pub fn len(&self) -> usize {
        self.observed.len()
    }

    /// Whether there are no observations; never so, for a file without rows is refused.
    pub fn is_empty(&self) -> bool {
        self.observed.is_empty()
    }
}
