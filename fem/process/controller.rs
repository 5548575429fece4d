//! Compensation in the controller of the axis: its resolution, and the table that was active during the test.

use crate::input::Reader;
use crate::positioning::{Law, Measures, Node, Steps, Table};

/// Most points at which increments are told.
const MOST_POINTS: f64 = 10_000.0;

/// The controller's compensation. SI units: m of a linear axis, rad of a rotary one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Controller {
    /// Step to which it rounds; 0 for none.
    pub resolution: f64,
    /// Table that was active during the test; `None` for none.
    pub active: Option<Table>,
    /// Points at which it takes increments, counted from its reference point.
    pub steps: Option<Steps>,
}

impl Controller {
    /// Reads `[controller]` for an axis that goes `travel` far, in these measures.
    pub fn read(t: &Reader, travel: f64, Measures { position: place, deviation: small }: Measures) -> Self {
        let about = "to which compensation values are rounded; exact if left out";
        let resolution = t.quantity("resolution", small, about).positive().or(0.0);
        let about = "backlash that it compensated during the test; none if left out";
        let backlash = t.quantity("backlash", small, about).or(0.0);
        let about = "pitch table that it had during the test, linear between; none if left out";
        let points = t.list("points", about, |t, _| {
            let at = t.quantity("at", place, "position of the point").required();
            (at, t.quantity("added", small, "added to the command there").required())
        });
        if points.windows(2).any(|w| w[1].0 <= w[0].0) {
            t.problem("points", "the positions do not rise", "give them from the least on, each once");
        }
        let steps = t.optional_table("steps", "points of equal distance at which it takes increments", |t| {
            let reference = t.quantity("reference", place, "position of the reference point").required();
            let interval = t.quantity("interval", place, "from one point to the next").positive().required();
            if travel > MOST_POINTS * interval {
                let message = format!("{} on {} are too many points", place.format(interval), place.format(travel));
                t.problem("interval", message, format!("at most {MOST_POINTS:.0} points are told"));
            }
            let about =
                "the controller's detection unit, in counts of which it takes increments; not counted if left out";
            let unit = t.quantity("detection_unit", small, about).positive().or(0.0);
            let about = "by which the controller multiplies every count";
            let magnification = t.count("magnification", about).between(1, 100).or(1);
            if unit == 0.0 && magnification != 1 {
                let help = format!("add detection_unit = \"1 {}\"", small.unit);
                t.problem("magnification", "it multiplies counts, and what a count is is not told", help);
            }
            let about = "number that it gives to the reference point, for files that hold numbers";
            let number = t.count("number", about).between(0, 100_000).optional();
            let unit = unit * magnification as f64;
            Steps { reference, interval, unit, magnification: magnification as i64, number: number.map(|n| n as i64) }
        });
        let node = |(position, added): (f64, f64)| Node { position, forward: added, backward: added - backlash };
        let nodes: Vec<Node> =
            if points.is_empty() { vec![node((0.0, 0.0))] } else { points.into_iter().map(node).collect() };
        let is_active = nodes.iter().any(|n| n.forward != 0.0 || n.backward != 0.0);
        Self { resolution, active: is_active.then_some(Table { law: Law::Points, nodes }), steps }
    }
}
