//! Headstock and tailstock yield like springs.
//!
//! Under the reaction Q a support gives way by Q/k, and the work with it: at the tool by that part of Q/k
//! which the shaft's rigid motion carries there. Between centres ΔD = 2·(P/k)·(1 − x/L)² at the headstock
//! and 2·(P/k)·(x/L)² at the tailstock [seed 002 (8), (9), (11)]. k in N/m, above zero; P in N. Left out:
//! mass and damping, play.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter, UnitRole, nothing};
use crate::units::STIFFNESS;

/// `headstock-compliance`.
pub static HEADSTOCK: Effect<1> = Effect {
    name: "headstock-compliance",
    about: "the headstock gives way under its reaction like a spring",
    law: "y = Q/k at x = 0",
    source: "seed 002 (8)-(11)",
    belongs: Belongs::Unit("headstock", UnitRole::Spring),
    odds: Odds::of(1.0, "every unit gives way"),
    parameters: [Parameter::stiffness(STIFFNESS, "stiffness of the headstock", (5.0, 1000.0))],
    look_alikes: &[
        (
            "carriage-compliance",
            "in a chuck, where both add P/k everywhere, a push against the headstock alone (a test of its joint, `fem new \
             stiffness`); elsewhere x: the headstock's share fades",
        ),
        ("headstock-contact", "a third force level: the contact yields less than in proportion"),
        ("spindle-thermal-drift", "more parts, or a second force: drift grows with time, not with force"),
        ("chuck-tilt", "near the chuck: a tilt leaves nothing there"),
        ("headstock-friction", "a pass from the other end: friction stays behind on the other side"),
    ],
    needs: nothing,
    act: |[stiffness], machine| machine.headstock.soften(stiffness),
};

/// `tailstock-compliance`.
pub static TAILSTOCK: Effect<1> = Effect {
    name: "tailstock-compliance",
    about: "the tailstock gives way under its reaction like a spring",
    law: "y = Q/k at x = L",
    source: "seed 002 (8)-(11)",
    belongs: Belongs::Unit("tailstock", UnitRole::Spring),
    odds: Odds::of(1.0, "every unit gives way"),
    parameters: [Parameter::stiffness(STIFFNESS, "stiffness of the tailstock", (5.0, 1000.0))],
    look_alikes: &[
        ("tailstock-contact", "a third force level: the contact yields less than in proportion"),
        ("guideway-taper", "a second force: a taper does not change with it"),
        ("tailstock-offset", "a second force: an offset does not change with it"),
        ("bed-twist", "a second force: a twist does not change with it"),
        ("guideway-height", "a second force: both grow with x squared, only one with the force"),
        ("tailstock-friction", "a pass from the other end, or more places where it begins"),
    ],
    needs: a_tailstock,
    act: |[stiffness], machine| machine.tailstock.soften(stiffness),
};

/// Checks the needs of effects of a tailstock: a workholding that has one.
pub fn a_tailstock(setup: &Setup) -> Result<(), String> {
    match setup.workholding.has_tailstock() {
        true => Ok(()),
        false => Err("needs a tailstock, and a shaft held by `chuck` has none".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn between_centres_a_support_adds_its_share_of_the_force_twice() {
        // 500 N, 50 N/um, at x = L/4: 10 um·(3/4)² and 10 um·(1/4)².
        for (name, expected) in [("headstock-compliance", 5.625), ("tailstock-compliance", 0.625)] {
            let [rigid, springy] = [f64::INFINITY, 50.0].map(|k| gap(&lathe("centres", name, &[k]), 0.15));
            assert!((springy - rigid - expected).abs() < 1e-9);
        }
    }
}
