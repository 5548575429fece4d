//! What a process can be measured by, and what a file has of it.

use crate::process::{Coordinate, Observable, Rows};
use crate::units::Kind;

/// An observable of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredObservable {
    /// Position in the process's list of observables.
    pub position: usize,
    /// Column name.
    pub name: &'static str,
    /// Kind of its errors, with the unit in which results give them.
    pub kind: Kind,
    /// Unit in which the file gives it.
    pub unit: String,
}

impl MeasuredObservable {
    /// Lists the observables that occur in rows.
    pub(super) fn of(rows: &Rows, observables: &[Observable]) -> Vec<Self> {
        let seen = observables.iter().enumerate().filter(|(i, _)| rows.observable.contains(i));
        seen.map(|(i, o)| Self::new(i, o, o.kind.unit)).collect()
    }

    pub(super) fn new(position: usize, observable: &Observable, unit: &str) -> Self {
        Self { position, name: observable.name, kind: observable.error_kind(), unit: unit.to_string() }
    }
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
pub(super) struct Vocabulary {
    pub(super) observables: &'static [Observable],
    pub(super) coordinates: &'static [Coordinate],
}
