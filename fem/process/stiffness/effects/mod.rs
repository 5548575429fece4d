//! The effects of a joint under test. One file and one line each.

mod contact_joint;
mod dry_friction;
mod gap;
mod preload;

use super::Curve;
use crate::process::Effect;

/// The registry.
pub const ALL: &[&dyn Effect<Curve>] =
    &[&gap::Gap, &contact_joint::ContactJoint, &dry_friction::DryFriction, &preload::Preload];

#[cfg(test)]
mod bench {
    //! A joint to try effects on.

    use super::super::{Branch, Curve, Setup, effect};
    use crate::process::{Active, act};

    /// A spring of 80 N/um under up to 1000 N with one effect of these canonical values; y in um under a force (N).
    pub fn displacement(name: &str, canonical: &[f64], force: f64, branch: Branch) -> f64 {
        let mut curve = Curve::ideal(&Setup { stiffness: 80e6, max_force: 1000.0, steps: 20 });
        let description = effect(name).unwrap().description();
        let values = description.parameters.iter().zip(canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
        act(super::ALL, &[Active { description, values, written: None }], &mut curve);
        1e6 * curve.displacement(force, branch)
    }
}
