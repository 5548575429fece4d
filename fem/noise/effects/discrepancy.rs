//! At every place there is an error that no law here has.

use super::super::term::{Acts, Column, MeasurementEffect, Size, Term};
use super::zero_shift;
use crate::measure::Measurements;

/// An unknown curve: every place along a coordinate has an error of its own, the same whenever it is
/// measured.
pub static DISCREPANCY: MeasurementEffect = MeasurementEffect {
    name: "discrepancy",
    about: "every place has an error of its own, the same whenever it is measured: a curve that no law here has",
    law: "y = prediction + e(level of `by`), e ~ N(0, size^2)",
    source: "Kennedy & O'Hagan, Bayesian calibration of computer models, J. R. Stat. Soc. B 63, 2001",
    separates: "measure at further places between: a curve of the machine goes on between them",
    size: Size::OfObservable("size", "standard deviation of the curve"),
    acts: Acts::Shared(columns),
};

fn columns(term: &Term, measurements: &Measurements) -> Vec<Column> {
    zero_shift::columns(term, measurements)
}
