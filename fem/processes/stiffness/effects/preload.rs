//! Two joints that press on each other.
//!
//! The joint u(Q) = Q/k + c·Qⁿ and a second one of the same law press on each other with P. A force S loads the
//! one and relieves the other: Q₁ − Q₂ = S, u(Q₁) + u(Q₂) = 2·u(P), y = u(Q₁) − u(P), until the second is relaxed
//! at u(S) = 2·u(P); from there y = u(S) − u(P), which is what fig. 5 b of seed 000 draws: less by what the preload
//! has pressed before. Springs alone resist with 2k up to S = 2P and with k beyond; contacts stay closed and stiff.
//! There is no clearance left to take up. S is the force that friction leaves; P in N, k in N/m, c in m/Nⁿ. Left
//! out: joints that differ, and friction that the preload itself brings.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, UnitRole};
use crate::units::FORCE;

/// `preload`.
pub static PRELOAD: Effect<1> = Effect {
    name: "preload",
    about: "a second joint presses against the first, and both resist until it is relaxed",
    law: "Q1 - Q2 = S, u(Q1) + u(Q2) = 2*u(P), y = u(Q1) - u(P) with u(Q) = Q/k + c*Q^n; y = u(S) - u(P) once Q2 = 0; \
          no gap",
    source: "seed 000, fig. 5; equations by statics",
    belongs: Belongs::Tested(UnitRole::Preload),
    odds: Odds::of(0.3, "bearings and screws are preloaded"),
    parameters: [Parameter::amplitude("force", FORCE, "preload P", (10.0, 2000.0))],
    look_alikes: &[(
        "contact-joint",
        "forces on both sides of where the curve bends: a preloaded joint softens, a contact stiffens",
    )],
    // A stiffness that is still unknown is none yet, and that of no joint is infinite.
    needs: |setup| match setup.stiffness.is_infinite() {
        true => Err("needs a [joint] of its own beside a structure".into()),
        false => Ok(()),
    },
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
