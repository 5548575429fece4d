//! Rings and rows for the table.

use std::sync::Arc;

use super::super::observe::{ANGLE_OF_ROW, COORDINATES, JAW_FORCE, RUN, SPEED, STATE};
use super::super::{Chucked, Setup, effect};
pub(super) use crate::process::row;
use crate::process::{Job, Rows, Tolerance, set_up};

/// What sums of doubles leave.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);

/// A steel ring of Ø100 × 20 mm, bore Ø84, deviations from the set circle. The words in capitals are replaced.
pub const RING: &str = r#"
    workpiece = { material = "steel", outer_diameter = "100 mm", inner_diameter = "BORE mm", width = "20 mm" }
    chuck = { jaws = JAWS, jaw_force = "3 kN" }
    cut = { spindle_speed = "400 rpm", force_per_depth = "1 kN/mm" }
    mesh = { circumferential = 360, radial = 6, order = 2 }
    measurement = { reference = "absolute" }
"#;

/// The text of a ring of this bore (mm) in so many jaws.
pub fn ring(bore: f64, jaws: usize) -> String {
    RING.replace("BORE", &bore.to_string()).replace("JAWS", &jaws.to_string())
}

/// The chuck of a model's text with effects given as TOML. A mistake in a text shows as NaN in every row that uses it, so no row can pass by it.
pub fn chuck(text: &str, effects: &str) -> Option<Chucked> {
    let (setup, active) = set_up(text, effects, Setup::read, |name| effect(name).map(|e| e.description()))?;
    Some(Chucked::equip(Arc::new(setup), &active))
}

/// Rows of one set-up at angles (rad), in the model's own conditions but for some columns.
pub fn rows(angles: &[f64], changes: &[(usize, f64)]) -> Rows {
    let mut columns = vec![vec![0.0; angles.len()]; COORDINATES.len()];
    columns[ANGLE_OF_ROW] = angles.to_vec();
    for column in [JAW_FORCE, SPEED] {
        columns[column].fill(f64::NAN);
    }
    columns[RUN].fill(1.0);
    for (column, value) in changes {
        columns[*column].fill(*value);
    }
    Rows { columns, observable: vec![0; angles.len()] }
}

/// Deviations at angles (rad), m; NaN where they cannot be computed.
pub fn deviations(chuck: &Option<Chucked>, angles: &[f64], changes: &[(usize, f64)]) -> Vec<f64> {
    let observed = chuck.as_ref().and_then(|c| c.observe(&rows(angles, changes)).ok());
    observed.unwrap_or_else(|| vec![f64::NAN; angles.len()])
}

/// Radial displacement of the clamped bore at an angle (rad), m.
pub fn clamped(chuck: &Option<Chucked>, angle: f64) -> f64 {
    deviations(chuck, &[angle], &[(STATE, 1.0)])[0]
}

/// Angles all around, rad.
pub fn around(count: usize) -> Vec<f64> {
    (0..count).map(|i| std::f64::consts::TAU * i as f64 / count as f64).collect()
}
