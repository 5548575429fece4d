//! The chuck tilts.
//!
//! A chuck holds the shaft's rotation like a spring, M = k·φ, and not like a wall. On a cantilever y +=
//! P·x²/k. k in N m/rad; only where there is a chuck. Left out: jaws that slip.

use super::super::machine::Effect;
use super::super::setup::{Setup, Workholding};
use crate::process::{Belongs, Odds, Parameter};
use crate::solve::Hold;
use crate::units::ROTATIONAL_STIFFNESS;

/// `chuck-tilt`.
pub static CHUCK_TILT: Effect<1> = Effect {
    name: "chuck-tilt",
    about: "the chuck yields to the bending moment like a rotational spring",
    law: "M = k*phi at the chuck; on a free shaft y += P*x^2/k",
    source: "statics; cf. seed 002 (14), (15)",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "chucks are clamped hard, and long work alone shows their tilt"),
    parameters: [Parameter::stiffness(ROTATIONAL_STIFFNESS, "rotational stiffness of the chuck", (10.0, 2000.0))],
    look_alikes: &[("headstock-compliance", "measure near the chuck: a tilt leaves nothing there")],
    needs: a_chuck,
    act: |[stiffness], machine| machine.hold = Hold::Compliance(1.0 / stiffness),
};

fn a_chuck(setup: &Setup) -> Result<(), String> {
    match setup.workholding {
        Workholding::Centres => Err("needs a chuck, and a shaft between `centres` has none".into()),
        Workholding::Chuck | Workholding::ChuckAndCentre => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_free_shaft_turns_about_the_chuck() {
        let stiff = lathe("chuck", "chuck-tilt", &[f64::INFINITY]);
        let tilting = lathe("chuck", "chuck-tilt", &[100.0]);
        // 500 N · (0.4 m)² / 100 kN m/rad = 800 um.
        assert!((gap(&tilting, 0.4) - gap(&stiff, 0.4) - 800.0).abs() < 1e-8);
    }
}
