//! The tailstock yields like a spring.
//!
//! Under the reaction Q the support at x = L gives way by Q/k, and the work with it: at the tool by that part of Q/k which
//! the shaft's rigid motion carries there. Between centres ΔD = 2·(P/k)·(x/L)² [seed 002 (8), (9), (11)].
//! k in N/m, above zero; P in N. Left out: mass and damping, play.

use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::STIFFNESS;

/// `tailstock-compliance`.
pub struct TailstockCompliance;

static DESCRIPTION: Description = Description {
    name: "tailstock-compliance",
    about: "the tailstock gives way under its reaction like a spring",
    law: "y = Q/k at x = L",
    source: "seed 002 (8)-(11)",
    parameters: &[Parameter::stiffness(STIFFNESS, "stiffness of the tailstock", (5.0, 1000.0))],
    look_alikes: &[
        ("tailstock-contact", "a third force level: the contact yields less than in proportion"),
        ("guideway-taper", "a second force: a taper does not change with it"),
        ("tailstock-offset", "a second force: an offset does not change with it"),
    ],
};

impl Effect<Machine> for TailstockCompliance {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        machine.tailstock.soften(values["stiffness"]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn between_centres_the_support_adds_its_share_of_the_force_twice() {
        // 500 N, 50 N/um, at x = L/4: 10 um·(1/4)².
        let rigid = lathe("centres", "tailstock-compliance", &[f64::INFINITY]);
        let springy = lathe("centres", "tailstock-compliance", &[50.0]);
        assert!((gap(&springy, 0.15) - gap(&rigid, 0.15) - 0.625).abs() < 1e-9);
    }
}
