//! Axes and tests for the table.

use crate::positioning::{Approach, Direction, Evaluation};
use crate::process::{Assembled, ForwardModel, assembled};
use crate::processes::axis::{Axis, rows};
use crate::validation::Tolerance;
pub(super) use crate::validation::bench::row;

/// An axis with its effects.
pub type Machine = Assembled<Axis>;

/// Round-off of sums of doubles.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);
/// Round-off of micrometres that nearly cancel, um.
pub const CANCELLED: Tolerance = Tolerance::Absolute(1e-9);

/// 800 mm of travel on a steel screw of 40 mm and 10 mm a turn, held at 50 mm.
const AXIS: &str = r#"
    axis = { travel = "800 mm" }
    screw = { material = "steel", diameter = "40 mm", lead = "10 mm", fixed_at = "50 mm" }
"#;

/// EA of that screw, N.
pub fn rigidity() -> f64 {
    210e9 * std::f64::consts::PI * 0.02 * 0.02
}

/// The axis with effects given as TOML. A mistake in a text shows as NaN in every row that uses it, so no
/// row can pass by it.
pub fn axis(effects: &str) -> Option<Machine> {
    assembled(AXIS, effects)
}

/// The same with more keys of the screw.
pub fn axis_with(screw: &str, effects: &str) -> Option<Machine> {
    assembled(&AXIS.replace("fixed_at = \"50 mm\"", &format!("fixed_at = \"50 mm\", {screw}")), effects)
}

/// The same with more keys of the axis itself.
pub fn axis_that(goes: &str, effects: &str) -> Option<Machine> {
    assembled(&AXIS.replace("travel = \"800 mm\"", &format!("travel = \"800 mm\", {goes}")), effects)
}

/// Deviation in um at a position (mm), forwards or backwards, after minutes.
pub fn deviation(axis: &Option<Machine>, position: f64, direction: Direction, minutes: f64) -> f64 {
    let rows = rows::rows([(1e-3 * position, direction, 1.0, 60.0 * minutes)]);
    axis.as_ref().and_then(|a| a.observe(&rows).ok()).map_or(f64::NAN, |d| 1e6 * d[0])
}

/// A test from its readings (position mm, direction, deviation um).
pub fn test(readings: impl IntoIterator<Item = (f64, Direction, f64)>) -> Evaluation {
    let (approaches, deviations): (Vec<Approach>, Vec<f64>) = readings
        .into_iter()
        .map(|(position, direction, um)| (Approach { position: 1e-3 * position, direction, run: 1.0 }, 1e-6 * um))
        .unzip();
    Evaluation::of(&approaches, &deviations)
}
