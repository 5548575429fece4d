//! The zero steps at a row.

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
    acts: Acts::Shared(columns),
};

fn columns(term: &Term, measurements: &Measurements) -> Vec<Column> {
    let first = term.rows.first().copied().unwrap_or(0);
    let rows = (first..measurements.len()).filter(|row| term.is_of(measurements, *row));
    vec![rows.map(|row| (row, 1.0)).collect()]
}
