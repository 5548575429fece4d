//! What was done between parts, as the model tells of it.

use super::super::events::{Correction, Events, InsertChange};
use crate::process::{Datum, Figure};
use crate::units::MICRO;

/// The figure with corrections and new inserts, if there are any.
pub fn told(events: &Events, figure: Figure) -> Figure {
    let Events { corrections, inserts, .. } = events;
    if corrections.is_empty() && inserts.is_empty() {
        return figure;
    }
    let corrected = |c: &Correction| {
        format!("after part {} the offset is corrected: diameters {:+.2}", c.after, MICRO.shown(c.diameter))
    };
    let renewed = |insert: &InsertChange| match insert.diameter {
        0.0 => format!("after part {} the insert is new", insert.after),
        off => format!("after part {} the insert is new, and leaves diameters {:+.2}", insert.after, MICRO.shown(off)),
    };
    let entry = |after: usize, diameter: f64| {
        Datum::record([("after", after.into()), ("diameter", Datum::Quantity(MICRO, diameter))])
    };
    figure
        .lines(corrections.iter().map(corrected))
        .lines(inserts.iter().map(renewed))
        .unit("diameter_unit", MICRO)
        .entry("corrections", Datum::List(corrections.iter().map(|c| entry(c.after, c.diameter)).collect()))
        .entry("inserts", Datum::List(inserts.iter().map(|i| entry(i.after, i.diameter)).collect()))
}
