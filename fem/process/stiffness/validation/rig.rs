//! Joints and rows for the table.

use super::super::Stiffness;
use super::super::curve::Branch;
use super::super::rows::along;
pub(super) use crate::process::row;
use crate::process::{Assembled, ForwardModel, Tolerance, assembled};

/// A joint with its effects.
pub type Machine = Assembled<Stiffness>;

/// What sums of doubles leave.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);

/// A spring of 80 N/um, loaded up to 1000 N, with effects given as TOML. A mistake in a text shows as NaN in
/// every row that uses it, so no row can pass by it.
pub fn joint(effects: &str) -> Option<Machine> {
    assembled("joint = { stiffness = \"80 N/um\" }\ntest = { max_force = \"1000 N\", steps = 20 }", effects)
}

/// y under a force (N) on loading, um.
pub fn up(joint: &Option<Machine>, force: f64) -> f64 {
    observed(joint, force, Branch::Load)
}

/// y under a force (N) on unloading, um.
pub fn down(joint: &Option<Machine>, force: f64) -> f64 {
    observed(joint, force, Branch::Unload)
}

fn observed(joint: &Option<Machine>, force: f64, branch: Branch) -> f64 {
    let rows = along(vec![force], branch);
    joint.as_ref().and_then(|j| j.observe(&rows).ok()).map_or(f64::NAN, |y| 1e6 * y[0])
}
