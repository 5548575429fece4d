//! Where the rows of each test stand among those of all.

use crate::input::Name;
use crate::noise::Term;
use crate::process::{Absent, Coordinate, Observable, Process, Rows, Values};

/// The observables of all tests, each test's its own, and the union of their coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Observables, test after test.
    pub observables: Vec<Observable>,
    /// Number of the first observable of each test, and of all of them.
    first: Vec<usize>,
    /// Coordinates; those of two tests that mean the same are one.
    pub coordinates: Vec<Coordinate>,
    /// Number, among these, of each coordinate of each test.
    columns: Vec<Vec<usize>>,
}

impl Layout {
    /// The layout of tests, given their names and processes.
    pub fn new<'t>(tests: impl IntoIterator<Item = (&'t Name, &'t dyn Process)>) -> Self {
        let mut layout = Self { observables: Vec::new(), first: vec![0], coordinates: Vec::new(), columns: Vec::new() };
        for (test, process) in tests {
            let first = layout.observables.len();
            let own = process.observables().iter().map(|o| Observable {
                name: format!("{} of {test}", o.name).into(),
                words: format!("{} of {test}", o.words).into(),
                ..o.clone()
            });
            layout.observables.extend(own);
            layout.first.push(layout.observables.len());
            let columns = process.coordinates().iter().map(|c| layout.column(c, first, process.name())).collect();
            layout.columns.push(columns);
        }
        layout
    }

    /// Number of a coordinate of a test, whose observables begin at `first`: one that is there, or a new one.
    fn column(&mut self, own: &Coordinate, first: usize, process: &str) -> usize {
        let is_same = |c: &Coordinate| (&c.name, &c.holds, c.repeats) == (&own.name, &own.holds, own.repeats);
        if let Some(same) = self.coordinates.iter().position(is_same) {
            return same;
        }
        let is_taken = self.coordinates.iter().any(|c| c.name == own.name);
        let name = if is_taken { format!("{} of {process}", own.name).into() } else { own.name.clone() };
        let absent = match own.absent {
            Absent::NeededBy(from, to) => Absent::NeededBy(first + from, first + to),
            Absent::NeededBut(observable) => Absent::NeededBut(first + observable),
            Absent::ModelOf(from, to) => Absent::ModelOf(first + from, first + to),
            other => other,
        };
        self.coordinates.push(Coordinate { name, absent, actual: own.actual.map(|o| first + o), ..own.clone() });
        self.coordinates.len() - 1
    }

    /// Number of an observable of a test among those of all.
    pub fn observable(&self, test: usize, own: usize) -> usize {
        self.first[test] + own
    }

    /// The test of an observable, and its number there.
    pub fn own_observable(&self, observable: usize) -> (usize, usize) {
        let test = self.first.partition_point(|first| *first <= observable) - 1;
        (test, observable - self.first[test])
    }

    /// Number of a coordinate of a test among those of all; what is no coordinate stays.
    pub fn coordinate(&self, test: usize, own: usize) -> usize {
        self.columns[test].get(own).copied().unwrap_or(own)
    }

    /// Name, among the coordinates of all tests, of a test's own coordinate.
    pub fn named(&self, test: usize, own: &str) -> Option<Name> {
        let mut columns = self.columns[test].iter().map(|number| &self.coordinates[*number].name);
        let is_own =
            |name: &&Name| **name == *own || name.strip_prefix(own).is_some_and(|rest| rest.starts_with(" of "));
        columns.find(is_own).cloned()
    }

    /// The rows of a test among all of these, by their numbers, and as its process knows them.
    pub fn own(&self, test: usize, rows: &Rows) -> (Vec<usize>, Rows) {
        let is_own = |row: &usize| self.own_observable(rows.observable[*row]).0 == test;
        let numbers: Vec<usize> = (0..rows.len()).filter(is_own).collect();
        let column = |number: &usize| numbers.iter().map(|row| rows.columns[*number][*row]).collect();
        let own = Rows {
            columns: self.columns[test].iter().map(column).collect(),
            observable: numbers.iter().map(|row| self.own_observable(rows.observable[*row]).1).collect(),
        };
        (numbers, own)
    }

    /// The rows of a test as rows among those of all; of coordinates that the test has not they have nothing.
    pub fn among_all(&self, test: usize, own: &Rows) -> Rows {
        let mut columns = vec![Values::shared(f64::NAN, own.len()); self.coordinates.len()];
        for (number, column) in self.columns[test].iter().zip(&own.columns) {
            columns[*number].clone_from(column);
        }
        Rows { columns, observable: own.observable.iter().map(|o| self.observable(test, *o)).collect() }
    }

    /// A term of a test, by its name, among those of all, in records of its file.
    pub fn term(&self, test: usize, name: &str, own: &Term) -> Term {
        let mut term = own.clone();
        term.table = format!("{name}.{}", term.table);
        term.by.iter_mut().for_each(|by| *by = self.coordinate(test, *by));
        term.along.iter_mut().for_each(|along| along.coordinate = self.coordinate(test, along.coordinate));
        term.observable = term.observable.map(|own| self.observable(test, own));
        term.among.iter_mut().for_each(|own| *own = self.observable(test, *own));
        term
    }
}
