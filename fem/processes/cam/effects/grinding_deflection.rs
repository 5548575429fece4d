//! Wheel and cam give way to the force of the cut.
//!
//! F_n = force_per_rate·Z', with Z' = stock·v the instantaneous removal rate per unit width, v the feed of
//! the grinding point along the profile as the programme means it: v = ω·|W|²/((1 + κR)·(W·n)) at one
//! speed of the cam, W the wheel's centre, κ the curvature of the profile. At one speed straight flanks are
//! ground many times faster than noses. F_n/k stays on the cam. Left out: the jumps of the grinding point
//! within a block, which are shorter than the contact and blurred by it, and passes after the first, which
//! take off what the first has left.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::STIFFNESS;

/// `grinding-deflection`.
pub static GRINDING_DEFLECTION: Effect<1> = Effect {
    name: "grinding-deflection",
    about: "wheel and cam give way to a force that follows the removal rate",
    law: "deviation += F_n/stiffness, F_n = cut.force_per_rate*cut.stock*feed of the grinding point",
    source: "seed 003 (removal rate)",
    belongs: Belongs::Test,
    odds: Odds::of(0.7, "every system gives way"),
    parameters: [Parameter::stiffness(STIFFNESS, "of wheel, slide and cam against each other", (2.0, 500.0))],
    look_alikes: &[("wheel-wear", "another cam speed: the force follows it")],
    needs: cut,
    act: |[stiffness], machine| machine.compliance = 1.0 / stiffness,
};

fn cut(setup: &Setup) -> Result<(), String> {
    match (setup.stock, setup.force_per_rate) {
        (None, _) => Err("needs the layer that is taken off: stock = \"20 um\" in [cut]".into()),
        (_, None) => Err("needs the force of the cut: force_per_rate = \"10 N/(mm^2/s)\" in [cut]".into()),
        (Some(_), Some(_)) => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_force_follows_the_removal_rate() {
        // At 0 deg the wheel's centre stands at 199 mm, ground is a circle of 20 mm: v =
        // ω·199²/((195/20)·199).
        let feed = 20.0 * std::f64::consts::TAU / 60.0 * 199.0 * 20.0 / 195.0;
        let expected = 10.0 * 0.02 * feed / 5.0;
        let computed = deviations("grinding-deflection", &[5.0], &[0.0])[0];
        assert!((computed - expected).abs() < 3e-3, "{computed} and {expected}");
    }
}
