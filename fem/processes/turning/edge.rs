//! The cutting edge: the wear land on its flank, and how wide it may become.

use std::sync::Arc;

use super::schedule::Schedule;
use crate::input::{Along, Reader, Record, Varying};
use crate::units::{ANGLE, LENGTH, PATH};

/// The table `[edge]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Tangent of the clearance angle α: a land of width h draws the edge back by U = h·tan α [seed 002 (31)].
    pub clearance: f64,
    /// Width of the wear land over the cutting path, both in m, where it is known.
    pub land: Option<Varying>,
    /// Width at which the edge is changed, m.
    pub largest_land: Option<f64>,
}

impl Edge {
    /// Reads `[edge]`. A record of the land must reach to the end of the batch.
    pub fn read(model: &Reader, schedule: &Schedule) -> Option<Self> {
        model.optional_table("edge", "the cutting edge and the wear land on its flank", |t| {
            let angle = t.quantity("clearance_angle", ANGLE, "clearance angle of the flank");
            let clearance = angle.within(0.0, 0.7).required().tan();
            let last = schedule.longest_path();
            let along = Along { name: "path", kind: PATH, needed: [0.0, last] };
            let about = "measured width of the wear land over the cutting path";
            let recorded = t.quantity("wear_land", LENGTH, about).not_negative().optional_varying(along);
            let given = read_points(t, last);
            if recorded.is_some() && given.is_some() {
                t.problem("land", "the wear land is given twice", "keep either `wear_land` or `land`");
            }
            let land = recorded.or(given.map(|points| Varying::Record(Arc::new(points))));
            let largest = t.quantity("largest_land", LENGTH, "width of the land at which the edge is changed");
            Self { clearance, land, largest_land: largest.positive().optional() }
        })
    }
}

/// Reads the land at a few paths, straight between them.
fn read_points(t: &Reader, last: f64) -> Option<Record> {
    let points = t.list("land", "width of the wear land at some paths, straight between them", |t, _| {
        let path = t.quantity("path", PATH, "cutting path of the edge").not_negative().required();
        [path, t.quantity("width", LENGTH, "width of the land there").not_negative().required()]
    });
    let end = points.last()?[0];
    // While a value is unknown, nothing can be said of its order.
    let is_known = points.iter().all(|p| p[0].is_finite());
    if is_known && end < last * (1.0 - 1e-9) {
        let message = format!("the land is known up to {}, and the batch cuts {}", PATH.format(end), PATH.format(last));
        t.problem("land", message, "give the width at the end of the batch too");
    }
    let record = Record::new(points);
    if record.is_none() && is_known && t.is_sound() {
        t.problem("land", "the paths do not rise", "give them in their order, each once");
    }
    record
}
