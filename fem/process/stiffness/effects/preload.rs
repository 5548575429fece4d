//! Two springs that press on each other.
//!
//! Preloaded by F₀ against a second spring of the same k, the joint is held by both until the second is
//! relaxed, at S = 2F₀: stiffness 2k up to there, k beyond [seed 000, fig. 5 b]; S is the force that
//! friction leaves. F₀ in N. It gives way by F₀/k less than the spring alone. Left out: springs that differ,
//! the clearance that a preload takes up.

use super::super::machine::Effect;
use crate::process::{Parameter, nothing};
use crate::units::FORCE;

/// `preload`.
pub static PRELOAD: Effect<1> = Effect {
    name: "preload",
    about: "a second spring presses against the first, and both resist until it is relaxed",
    law: "dS/dy = 2*k until S = 2*force, then k",
    source: "seed 000, fig. 5",
    parameters: [Parameter::amplitude("force", FORCE, "preload", (10.0, 2000.0))],
    look_alikes: &[(
        "contact-joint",
        "forces on both sides of where the curve bends: a preloaded joint softens, a contact stiffens",
    )],
    needs: nothing,
    act: |[force], machine| machine.curve.preload += force,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn both_springs_resist_until_one_is_relaxed() {
        for (force, expected) in [(160.0, 1.0), (400.0, 2.5), (1000.0, 10.0)] {
            assert!((displacement("preload", &[200.0], force, Load) - expected).abs() < 1e-9);
        }
    }
}
