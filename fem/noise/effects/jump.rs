//! The zero steps at a row.

use super::super::evidence::Evidence;
use super::super::key::{FROM, IN_FILE, OBSERVABLE};
use super::super::term::{Acts, Column, MeasurementEffect, Size, Term};
use crate::measure::Measurements;

/// From one row of the file on, everything is higher or lower.
pub static JUMP: MeasurementEffect = MeasurementEffect {
    name: "jump",
    about: "from one row of the file on the zero is another: something was touched, clamped anew or switched",
    law: "y = prediction + size * (row >= first row)",
    source: "a step (intervention) of known place: Box & Tiao, J. Am. Stat. Assoc. 70, 1975",
    separates: "measure a master before and after, and the rows in another order",
    size: Size::OfObservable("size", "height of the step"),
    keys: &[OBSERVABLE, FROM, IN_FILE],
    example: "0.7 um",
    // A place among all rows counts as two parameters (Zhang and Siegmund 2007).
    parameters: 3.0,
    sets_zero: true,
    acts: Acts::Shared(columns),
    ..MeasurementEffect::USUAL
};

/// One for each observable, where it gains most.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    let steps = evidence.each(Term::new(&JUMP)).filter_map(|term| evidence.scan().step(&term));
    steps.map(|term| evidence.and(term)).collect()
}

fn columns(term: &Term, measurements: &Measurements) -> Vec<Column> {
    let first = term.rows.first().copied().unwrap_or(0);
    let rows = (first..measurements.len()).filter(|row| term.is_of(measurements, *row));
    vec![rows.map(|row| (row, 1.0)).collect()]
}
