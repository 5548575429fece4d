//! Columns by which a process can be measured, and those that a file has.

use crate::input::Name;
use crate::process::{Coordinate, Observable, Process, Rows};
use crate::units::Kind;

/// An observable of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredObservable {
    /// Position in the process's list of observables.
    pub position: usize,
    /// Column name.
    pub name: Name,
    /// Kind of its errors, with the unit in which results give them.
    pub kind: Kind,
    /// Unit in which the file gives it.
    pub unit: String,
    /// What it is.
    pub observable: Observable,
}

impl MeasuredObservable {
    /// Lists the observables that occur in rows.
    pub(super) fn of(rows: &Rows, observables: &[Observable]) -> Vec<Self> {
        let seen = observables.iter().enumerate().filter(|(i, _)| rows.observable.contains(i));
        seen.map(|(i, o)| Self::new(i, o, &o.kind.unit)).collect()
    }

    pub(super) fn new(position: usize, observable: &Observable, unit: &str) -> Self {
        Self {
            position,
            name: observable.name.clone(),
            kind: observable.error_kind(),
            unit: unit.to_string(),
            observable: observable.clone(),
        }
    }
}

/// Whether measurement files of a process have a column of this name.
pub fn is_column(process: &dyn Process, name: &str) -> bool {
    Vocabulary::of(process).knows(name)
}

/// Purpose for which a file is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Purpose {
    /// The rows were measured.
    Measured,
    /// The rows are planned.
    Design,
}

/// Columns that a process knows.
#[derive(Clone, Copy)]
pub(super) struct Vocabulary<'p> {
    pub(super) process: &'static str,
    pub(super) observables: &'p [Observable],
    pub(super) coordinates: &'p [Coordinate],
}

impl<'p> Vocabulary<'p> {
    pub(super) fn of(process: &'p dyn Process) -> Self {
        Self { process: process.name(), observables: process.observables(), coordinates: process.coordinates() }
    }

    /// Whether a name is that of a column.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.names().any(|known| known == name)
    }

    /// Names of all columns, those of uncertainties and actual values last.
    pub(super) fn names(&self) -> impl Iterator<Item = String> {
        let own = self.coordinates.iter().map(|c| &c.name).chain(self.observables.iter().map(|o| &o.name));
        let uncertainties = self.observables.iter().map(|o| format!("u_{}", o.name));
        let actual = self.coordinates.iter().filter(|c| c.actual.is_some());
        let actual = actual.flat_map(|c| ["actual".to_string(), format!("actual_{}", c.name)]);
        own.map(Name::to_string).chain(["u".to_string()]).chain(uncertainties).chain(actual)
    }

    pub(super) fn coordinate(&self, name: &str) -> Option<&'p Coordinate> {
        self.coordinates.iter().find(|c| c.name == name)
    }
}
