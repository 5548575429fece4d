//! A compensation: for people, for programs, and for controllers.

mod controller;
mod json;
mod text;

pub use json::json;
pub use text::text;

use super::csv;
use crate::compensate::Compensation;

/// The table of LinuxCNC's compensation.
pub const LINUXCNC: &str = "linuxcnc.comp";

/// The tables for controllers and what is left along the travel, by the names of their files:
/// `linuxcnc.comp` only where it takes as many targets, what is entered only where the controller had something
/// already, and increments only where it is told at which points.
pub(super) fn tables(compensation: &Compensation) -> [(&'static str, Option<String>); 7] {
    let [points, segments, both] = &compensation.schemes;
    let entered = compensation.active.as_ref().map(|_| csv::table(&controller::points(&points.entered)));
    let increments = compensation.steps.map(|steps| csv::table(&controller::increments(&points.entered, steps)));
    [
        ("entered.csv", entered),
        ("increments.csv", increments),
        ("points.csv", Some(csv::table(&controller::points(&points.table)))),
        ("segments.csv", Some(csv::table(&controller::segments(&segments.table)))),
        ("both-directions.csv", Some(csv::table(&controller::both_directions(&both.table)))),
        (LINUXCNC, controller::linuxcnc(&both.entered)),
        ("predicted.csv", Some(csv::table(&controller::predicted(compensation)))),
    ]
}
