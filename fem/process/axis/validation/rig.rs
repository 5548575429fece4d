//! Axes and tests for the table.

use std::sync::Arc;

use super::super::{Driven, Moment, Setup, effect};
use crate::positioning::{Approach, Direction, Evaluation};
pub(super) use crate::process::row;
use crate::process::{Tolerance, set_up};

/// What sums of doubles leave.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);
/// What sums of doubles leave of micrometres that nearly cancel, um.
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

/// The axis with one effect given as TOML. A mistake in a text shows as NaN in every row that uses it, so no row can pass by it.
pub fn axis(effects: &str) -> Option<Driven> {
    let describe = |name: &str| Some(effect(name)?.description());
    let (setup, active) = set_up(AXIS, effects, Setup::read, describe)?;
    Some(Driven::equip(Arc::new(setup), &active))
}

/// Deviation in um at a position (mm), forwards or backwards, after minutes.
pub fn deviation(axis: &Option<Driven>, position: f64, direction: Direction, minutes: f64) -> f64 {
    let at = Moment { position: 1e-3 * position, direction, time: 60.0 * minutes };
    axis.as_ref().map_or(f64::NAN, |a| 1e6 * a.deviation(&at))
}

/// A test from its readings (position mm, direction, deviation um).
pub fn test(readings: impl IntoIterator<Item = (f64, Direction, f64)>) -> Evaluation {
    let (approaches, deviations): (Vec<Approach>, Vec<f64>) = readings
        .into_iter()
        .map(|(position, direction, um)| (Approach { position: 1e-3 * position, direction, run: 1.0 }, 1e-6 * um))
        .unzip();
    Evaluation::of(&approaches, &deviations)
}
