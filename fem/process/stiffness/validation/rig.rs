//! Joints and rows for the table.

use std::sync::Arc;

use super::super::observe::UNLOAD;
use super::super::{Pushed, Setup, effect};
pub(super) use crate::process::row;
use crate::process::{Job, Rows, Tolerance, set_up};

/// What sums of doubles leave.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);

/// A spring of 80 N/um, loaded up to 1000 N, with effects given as TOML. A mistake in a text shows as NaN in every row that uses it, so no row can
/// pass by it.
pub fn joint(effects: &str) -> Option<Pushed> {
    let text = "joint = { stiffness = \"80 N/um\" }\ntest = { max_force = \"1000 N\", steps = 20 }";
    let (setup, active) = set_up(text, effects, Setup::read, |name| effect(name).map(|e| e.description()))?;
    Some(Pushed::equip(Arc::new(setup), &active))
}

/// y under a force (N) on loading, um.
pub fn up(joint: &Option<Pushed>, force: f64) -> f64 {
    observed(joint, force, 0.0)
}

/// y under a force (N) on unloading, um.
pub fn down(joint: &Option<Pushed>, force: f64) -> f64 {
    observed(joint, force, UNLOAD)
}

fn observed(joint: &Option<Pushed>, force: f64, branch: f64) -> f64 {
    let rows = Rows { columns: vec![vec![force], vec![branch]], observable: vec![0] };
    joint.as_ref().and_then(|j| j.observe(&rows).ok()).map_or(f64::NAN, |y| 1e6 * y[0])
}
