//! Machines and points for the table.

use crate::process::Assembled;
use crate::process::assembled;
use crate::processes::contour::Contour;
use crate::processes::contour::forward::Lap;
use crate::processes::contour::path::Direction;
pub(super) use crate::validation::bench::{figure as figure_of, row};
use crate::validation::{Case, Tolerance};

/// Two axes with their effects.
pub type Machine = Assembled<Contour>;

pub const CCW: Direction = Direction::CounterClockwise;
pub const CW: Direction = Direction::Clockwise;
pub const WAYS: [Direction; 2] = [CCW, CW];
/// Round-off of sums of doubles.
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

/// The machine of a model's text with effects given as TOML. A mistake in a text shows as NaN in every row
/// that uses it, so no row can pass by it.
pub fn machine(text: &str, effects: &str) -> Option<Machine> {
    assembled(text, effects)
}

/// Reads a lap at the model's feed; NaN where there is no machine.
pub fn of_lap(machine: &Option<Machine>, direction: Direction, read: impl Fn(&Lap) -> f64) -> f64 {
    machine.as_ref().map_or(f64::NAN, |m| read(&Lap::new(m.machine(), direction, m.setup().feed)))
}

/// Deviation at a polar angle (deg), m.
pub fn deviation(machine: &Option<Machine>, direction: Direction, angle: f64) -> f64 {
    let path = machine.as_ref().map(|m| &m.setup().path);
    of_lap(machine, direction, |lap| {
        path.map_or(f64::NAN, |p| lap.deviation(&p.at(angle.to_radians().rem_euclid(std::f64::consts::TAU))))
    })
}
