//! Machines and points for the table.

use std::sync::Arc;

use super::super::machine::Lap;
use super::super::path::Direction;
use super::super::{Contouring, Setup, effect};
pub(super) use crate::process::row;
use crate::process::{Case, Job, Tolerance, set_up};
use crate::progress::Progress;

pub const CCW: Direction = Direction::CounterClockwise;
pub const CW: Direction = Direction::Clockwise;
pub const WAYS: [Direction; 2] = [CCW, CW];
/// What sums of doubles leave.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);
/// Servos that follow at once, 1/s: what they leave of a circle of 150 mm at 1000 mm/min is below 1e-9 um.
pub const STIFF: f64 = 1e6;

/// A deviation in um, met within `allowed` um.
pub fn micro(name: String, (expected, computed): (f64, f64), allowed: f64, source: &'static str) -> Case {
    row(name, "deviation", (1e6 * expected, 1e6 * computed, "um"), Tolerance::Absolute(1e6 * allowed), source)
}

/// The text of a circle: radius (mm), feed (mm/min), gain (1/s); leads of 10 mm.
pub fn circle(radius: f64, feed: f64, gain: f64) -> String {
    format!(
        "path = {{ shape = \"circle\", radius = \"{radius} mm\", feed = \"{feed} mm/min\" }}\n\
         drives = {{ gain = \"{gain} /s\", lead = \"10 mm\" }}\n"
    )
}

/// The text of a rectangle of 80 × 50 mm at an angle (deg), at 1000 mm/min with a gain (1/s).
pub fn rectangle(angle: f64, gain: f64) -> String {
    format!(
        "path = {{ shape = \"rectangle\", width = \"80 mm\", height = \"50 mm\", angle = \"{angle} deg\", feed = \"1000 mm/min\" }}\n\
         drives = {{ gain = \"{gain} /s\", lead = \"10 mm\" }}\n"
    )
}

/// The machine of a model's text with effects given as TOML. A mistake in a text shows as NaN in every row that uses it, so no row can pass by it.
pub fn machine(text: &str, effects: &str) -> Option<Contouring> {
    let (setup, active) = set_up(text, effects, Setup::read, |name| effect(name).map(|e| e.description()))?;
    Some(Contouring::equip(Arc::new(setup), &active))
}

/// What is read of a lap at the model's feed; NaN where there is no machine.
pub fn of_lap(machine: &Option<Contouring>, direction: Direction, read: impl Fn(&Lap) -> f64) -> f64 {
    machine.as_ref().map_or(f64::NAN, |m| read(&Lap::new(&m.machine, direction, m.setup().feed)))
}

/// Deviation at a polar angle (deg), m.
pub fn deviation(machine: &Option<Contouring>, direction: Direction, angle: f64) -> f64 {
    let path = machine.as_ref().map(|m| m.setup().path);
    of_lap(machine, direction, |lap| {
        path.map_or(f64::NAN, |p| lap.deviation(&p.at(angle.to_radians().rem_euclid(std::f64::consts::TAU))))
    })
}

/// A number of a run's findings by the finding's key and its path inside; NaN where there is none.
pub fn found(machine: &Option<Contouring>, finding: &str, path: &str) -> f64 {
    let outcome = machine.as_ref().and_then(|m| m.outcome(m.predict(&Progress::default()).ok()?).ok());
    let json = outcome.as_ref().and_then(|o| o.findings.iter().find(|f| f.key == finding)).map(|f| f.json.clone());
    json.and_then(|j| j.pointer(path).and_then(serde_json::Value::as_f64)).unwrap_or(f64::NAN)
}
