//! Joints and rows for the table.

use crate::process::{Assembled, ForwardModel, assembled};
use crate::processes::stiffness::Stiffness;
use crate::processes::stiffness::curve::Branch;
use crate::processes::stiffness::rows::along;
use crate::validation::Tolerance;
pub(super) use crate::validation::bench::{bisect, figure as figure_of, row};

/// A joint with its effects.
pub type Machine = Assembled<Stiffness>;

/// Round-off of sums of doubles.
pub const ROUND_OFF: Tolerance = Tolerance::Relative(1e-12);

/// A spring of 80 N/um, loaded up to 1000 N, with effects given as TOML. A mistake in a text shows as NaN in
/// every row that uses it, so no row can pass by it.
pub fn joint(effects: &str) -> Option<Machine> {
    under("1000 N", "from-zero", effects)
}

/// The same under a force that runs from 1000 N to -1000 N and back.
pub fn reversed(effects: &str) -> Option<Machine> {
    under("1000 N", "reversed", effects)
}

/// The same with another largest force and loading.
pub fn under(force: &str, loading: &str, effects: &str) -> Option<Machine> {
    let test = format!("test = {{ max_force = \"{force}\", steps = 20, loading = \"{loading}\" }}");
    assembled(&format!("joint = {{ stiffness = \"80 N/um\" }}\n{test}"), effects)
}

/// y (um) under S (N) of two joints of 80 N/um and the contact of `c` um/N^0.5 that press on each other with
/// `preload` N: the force of the second by bisection.
pub fn pressed(c: f64, s: f64, preload: f64) -> f64 {
    let u = |q: f64| q / 80.0 + c * q.sqrt();
    let second = bisect(0.0, preload, |q| u(s + q) + u(q) - 2.0 * u(preload));
    u(s + second) - u(preload)
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
