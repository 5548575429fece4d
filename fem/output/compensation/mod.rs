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
/// `linuxcnc.comp` only where it takes as many targets.
pub(super) fn tables(compensation: &Compensation) -> [(&'static str, Option<String>); 5] {
    let [points, segments, both] = &compensation.schemes;
    [
        ("points.csv", Some(csv::table(&controller::points(&points.table)))),
        ("segments.csv", Some(csv::table(&controller::segments(&segments.table)))),
        ("both-directions.csv", Some(csv::table(&controller::both_directions(&both.table)))),
        (LINUXCNC, controller::linuxcnc(&both.table)),
        ("predicted.csv", Some(csv::table(&controller::predicted(compensation)))),
    ]
}
