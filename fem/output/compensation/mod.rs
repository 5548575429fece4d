//! A compensation: for people, for programs, and for controllers.

mod control;
mod controller;
mod json;
mod text;

pub use control::{ALL as CONTROLS, Control, LINUXCNC, Supplied, supplied};
pub use json::json;
pub use text::text;

use super::csv;
use crate::compensate::Compensation;

/// The tables in general form and what is left along the travel, by the names of their files, and files for controls:
/// what is entered only where the controller had something already, and increments only where it is told at which
/// points.
pub(super) fn tables(compensation: &Compensation, supplied: &[Supplied]) -> Vec<(&'static str, Option<String>)> {
    let [points, segments, both] = &compensation.schemes;
    let entered = compensation.active.as_ref().map(|_| csv::table(&controller::points(&points.entered)));
    let increments = compensation.steps.map(|steps| csv::table(&controller::increments(&points.entered, steps)));
    let mut tables = vec![
        ("entered.csv", entered),
        ("increments.csv", increments),
        ("points.csv", Some(csv::table(&controller::points(&points.table)))),
        ("segments.csv", Some(csv::table(&controller::segments(&segments.table)))),
        ("both-directions.csv", Some(csv::table(&controller::both_directions(&both.table)))),
    ];
    tables.extend(supplied.iter().flat_map(|s| s.files.iter().map(|(name, text)| (*name, Some(text.clone())))));
    tables.push(("predicted.csv", Some(csv::table(&controller::predicted(compensation)))));
    tables
}
