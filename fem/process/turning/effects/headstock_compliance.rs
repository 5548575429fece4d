//! The headstock yields like a spring.
//!
//! Under the reaction Q the support at x = 0 gives way by Q/k, and the work with it: at the tool by that part of Q/k which
//! the shaft's rigid motion carries there. Between centres ΔD = 2·(P/k)·(1 − x/L)² [seed 002 (8), (9), (11)].
//! k in N/m, above zero; P in N. Left out: mass and damping, play.

use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::STIFFNESS;

/// `headstock-compliance`.
pub struct HeadstockCompliance;

static DESCRIPTION: Description = Description {
    name: "headstock-compliance",
    about: "the headstock gives way under its reaction like a spring",
    law: "y = Q/k at x = 0",
    source: "seed 002 (8)-(11)",
    parameters: &[Parameter::stiffness(STIFFNESS, "stiffness of the headstock", (5.0, 1000.0))],
    look_alikes: &[
        (
            "carriage-compliance",
            "nothing in a chuck, where both add P/k everywhere; elsewhere x: the headstock's share fades",
        ),
        ("headstock-contact", "a third force level: the contact yields less than in proportion"),
        ("spindle-thermal-drift", "more parts, or a second force: drift grows with time, not with force"),
    ],
};

impl Effect<Machine> for HeadstockCompliance {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        machine.headstock.soften(values["stiffness"]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn between_centres_the_support_adds_its_share_of_the_force_twice() {
        // 500 N, 50 N/um, at x = L/4: 10 um·(3/4)².
        let rigid = lathe("centres", "headstock-compliance", &[f64::INFINITY]);
        let springy = lathe("centres", "headstock-compliance", &[50.0]);
        assert!((gap(&springy, 0.15) - gap(&rigid, 0.15) - 5.625).abs() < 1e-9);
    }
}
