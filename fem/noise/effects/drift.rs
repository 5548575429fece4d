//! The zero wanders while rows are taken.

use super::super::evidence::Evidence;
use super::super::key::OBSERVABLE;
use super::super::term::{Acts, Column, MeasurementEffect, Size, Term};
use crate::measure::Measurements;

/// The zero moves steadily in the order in which the rows stand.
pub static DRIFT: MeasurementEffect = MeasurementEffect {
    name: "drift",
    about: "the zero of the instrument moves steadily while the rows are taken",
    law: "y = prediction + size * (row - middle)/(rows/2)",
    source: "ISO 230-3:2020, environmental temperature variation error: drift of the measuring set-up",
    separates: "measure a master before and after, or the rows in another order",
    size: Size::OfObservable("size", "half of what the zero moves from the first row to the last"),
    keys: &[OBSERVABLE],
    example: "0.7 um",
    acts: Acts::Shared(columns),
    ..MeasurementEffect::USUAL
};

/// One for each observable.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    evidence.each_new(Term::new(&DRIFT)).collect()
}

fn columns(term: &Term, measurements: &Measurements) -> Vec<Column> {
    let rows: Vec<usize> = (0..measurements.len()).filter(|row| term.is_of(measurements, *row)).collect();
    let half = 0.5 * (measurements.len().max(2) - 1) as f64;
    vec![rows.into_iter().map(|row| (row, row as f64 / half - 1.0)).collect()]
}
