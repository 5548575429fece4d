//! The joint closes by the contact law.
//!
//! Rough surfaces approach by y = c·Sⁿ, n < 1, much at first and little later [seed 002 (29)], in series
//! with the spring; S is the force that friction leaves, F itself where there is none. Under a preload the joint on
//! either side has its contact, and both stay closed until one is relaxed. c in m/Nⁿ, n in (0, 1]. Left out:
//! hysteresis of the contact itself.

use super::super::machine::Effect;
use crate::input::Bounds;
use crate::process::{Belongs, Odds, Parameter, UnitRole, nothing};
use crate::units::{CONTACT_COEFFICIENT, NUMBER};

/// `contact-joint`.
pub static CONTACT_JOINT: Effect<2> = Effect {
    name: "contact-joint",
    about: "surfaces in contact approach, much at first and little later",
    law: "y += c*S^n, n < 1, S the force that friction leaves",
    source: "seed 002 (29)",
    belongs: Belongs::Tested(UnitRole::Contact),
    odds: Odds::of(0.5, "every joint is one, but of a preloaded one a spring says as much"),
    parameters: [
        Parameter::amplitude("c", CONTACT_COEFFICIENT, "coefficient of the contact", (0.01, 5.0)),
        Parameter::shape("n", NUMBER, "exponent of the force", (0.3, 0.8)).within(Bounds::Within(0.0, 1.0)),
    ],
    look_alikes: &[
        ("preload", "forces on both sides of where the curve bends: a preloaded joint softens, a contact stiffens"),
        ("gap", "small forces: clearance opens at once"),
        ("settling", "both branches: what settles stays, a contact comes back"),
        ("datum-offset", "small forces: a contact closes little by little"),
    ],
    needs: nothing,
    act: |[c, n], machine| machine.curve.joint.add_contact(c, n),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_law_adds_to_the_spring() {
        for branch in [Load, Unload] {
            assert!((displacement("contact-joint", &[0.2, 0.5], 400.0, branch) - (5.0 + 4.0)).abs() < 1e-9);
        }
    }
}
