//! Axes and tests for the table.

use std::f64::consts::PI;

use crate::positioning::{Approach, Direction, Evaluation};
use crate::process::{Assembled, ForwardModel, assembled};
use crate::processes::rotary::{Rotary, rows};
use crate::validation::Tolerance;
pub(super) use crate::validation::bench::row;

/// An axis with its effects.
pub type Machine = Assembled<Rotary>;

/// Round-off of seconds of arc that nearly cancel, arcsec. A worm's phase is some hundred turns, of which 16 digits are kept.
pub const ROUND_OFF: Tolerance = Tolerance::Absolute(1e-8);

/// Seconds of arc in a radian.
pub const ARCSEC: f64 = 648_000.0 / PI;

/// A worm of 1:120 whose wheel has a pitch radius of 150 mm, and a ring of 80 mm and 1024 lines on the table.
pub const WORM: &str = r#"
    axis = { range = "360 deg" }
    drive = { type = "worm", teeth = 120, pitch_radius = "150 mm" }
    scale = { at = "table", radius = "80 mm", lines = 1024 }
"#;
/// A worm of two starts on 90 teeth, behind gears of 12:48.
pub const GEARED: &str = r#"
    axis = { range = "360 deg" }
    drive = { type = "worm", teeth = 90, starts = 2, stages = [{ driving = 12, driven = 48 }] }
"#;
/// Gears of 15:60 and 18:90, and an encoder of 500 lines on the motor.
pub const TRAIN: &str = r#"
    axis = { range = "200 deg", from = "-100 deg" }
    drive = { type = "gears", stages = [{ driving = 15, driven = 60 }, { driving = 18, driven = 90 }], pitch_radius = "60 mm" }
    scale = { at = "motor", lines = 500 }
"#;
/// A tilting axis whose drive yields by an arc second under 4 N·m.
pub const TILTING: &str = r#"
    axis = { range = "360 deg", orientation = "horizontal" }
    drive = { type = "worm", teeth = 120, stiffness = "4 N*m/arcsec" }
"#;

/// An axis with effects given as TOML. A mistake in a text shows as NaN in every row that uses it, so no row can pass by it.
pub fn axis(tables: &str, effects: &str) -> Option<Machine> {
    assembled(tables, effects)
}

/// Deviation in arcsec at an angle (deg), from a side, after minutes, under a torque (N·m).
pub fn deviation(axis: &Option<Machine>, angle: f64, direction: Direction, (minutes, torque): (f64, f64)) -> f64 {
    let rows = rows::rows([(angle.to_radians(), direction, 1.0, 60.0 * minutes)], torque);
    axis.as_ref().and_then(|a| a.observe(&rows).ok()).map_or(f64::NAN, |d| ARCSEC * d[0])
}

/// A test from its readings (angle deg, direction, deviation arcsec).
pub fn test(readings: impl IntoIterator<Item = (f64, Direction, f64)>) -> Evaluation {
    let (approaches, deviations): (Vec<Approach>, Vec<f64>) = readings
        .into_iter()
        .map(|(angle, direction, off)| (Approach { position: angle.to_radians(), direction, run: 1.0 }, off / ARCSEC))
        .unzip();
    Evaluation::of(&approaches, &deviations)
}
