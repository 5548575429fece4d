//! The steady rests stand out of line.
//!
//! Every steady rest stands off the line of the shaft by `offset` (m), away from the tool, besides what the model says of
//! it: its spring pushes the shaft by k·(offset − w), in the same equilibrium as cut and supports. An even slender shaft
//! between centres with one rest in the middle is pushed there by k·offset/(1 + k·L³/48EI), ΔD(L/2) += 2·offset·κ/(1 +
//! κ) with κ = k·L³/48EI [force method]. Left out: rests that stand off each by another amount, and jaws of a rest that
//! lift off.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::MICRO;

/// `rest-offset`.
pub static REST_OFFSET: Effect<1> = Effect {
    name: "rest-offset",
    about: "the steady rests stand out of line, and bend the shaft",
    law: "every rest pushes with k*(offset - w); an even shaft between centres, rest in the middle: dD += 2*offset*k/(k + 48EI/L^3) there",
    source: "statics; cf. seed 002 (8), (12)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "a rest is set by hand"),
    parameters: [Parameter::signed("offset", MICRO, "offset of the rests away from the tool", (-100.0, 100.0))],
    look_alikes: &[("guideway-wear", "a pass without the rest: wear stays")],
    needs: a_rest,
    act: |[offset], machine| machine.rests_offset += offset,
};

fn a_rest(setup: &Setup) -> Result<(), String> {
    match setup.steady_rests.is_empty() {
        true => Err("needs a steady rest: steady_rests = [{ at = \"300 mm\", stiffness = \"40 N/um\" }]".into()),
        false => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;
    use crate::process::with_effect;

    #[test]
    fn the_rest_pushes_against_the_shaft() {
        let text = model("centres").replace(
            "type = \"centres\"",
            "type = \"centres\", steady_rests = [{ at = \"300 mm\", stiffness = \"40 N/um\" }]",
        ) + "mesh = { beam = \"euler-bernoulli\" }\n";
        let pushed = with_effect::<super::super::super::Turning>(&text, "rest-offset", &[25.0]);
        let inertia = std::f64::consts::PI * 0.05f64.powi(4) / 64.0;
        let stiffer = 40e6 * 0.6f64.powi(3) / (48.0 * 210e9 * inertia);
        let moved =
            1e6 * unloaded(pushed.machine(), &super::super::super::machine::Moment { x: 0.3, ..moment() }).unwrap();
        assert!((moved - 50.0 * stiffer / (1.0 + stiffer)).abs() < 1e-9, "{moved}");
    }
}
