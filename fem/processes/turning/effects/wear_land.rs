//! The flank wears to a land, and the edge draws back by it.
//!
//! ΔD += 2·U, U = share·h(ℓ)·tan α [seed 002 (31)]: h the width of the wear land after the cutting path ℓ, as
//! `[edge]` has it measured or given, α the clearance angle. share is the part of U that the nose shows: 1 where
//! the land at the nose is as wide as the one that is measured. Left out: wear of the rake.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::FACTOR;

/// `wear-land`.
pub static WEAR_LAND: Effect<1> = Effect {
    name: "wear-land",
    about: "the edge draws back by the wear land on its flank, whose width over the path is known",
    law: "dD += 2*share*h(l)*tan(clearance_angle)",
    source: "seed 002 (31)",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "every edge wears, but few lands are measured"),
    parameters: [
        Parameter::amplitude("share", FACTOR, "part of the land's draw-back that the nose shows", (0.5, 2.0)).or(1.0)
    ],
    look_alikes: &[("tool-wear", "the width of the land, measured with a microscope between more parts")],
    needs: a_land,
    act: |[share], machine| {
        let Some(edge) = machine.setup.edge.clone() else { return };
        let Some(land) = edge.land else { return };
        machine.add_wear(move |path| share * edge.clearance * land.at(path));
    },
};

fn a_land(setup: &Setup) -> Result<(), String> {
    match setup.edge.as_ref().is_some_and(|edge| edge.land.is_some()) {
        true => Ok(()),
        false => Err("needs the wear land over the path: `wear_land` or `land` in [edge]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;
    use crate::process::with_effect;

    #[test]
    fn the_edge_draws_back_by_the_land_times_the_tangent() {
        // 0.2 mm at 800 m, by the straight line from 0.1 mm at 0 m to 0.6 mm at 4 km; α = 10°.
        let land = "land = [{ path = \"0 m\", width = \"0.1 mm\" }, { path = \"4 km\", width = \"0.6 mm\" }]";
        let text = format!("{}\nedge = {{ clearance_angle = \"10 deg\", {land} }}", model("centres"));
        let shift = with_effect::<super::super::super::Turning>(&text, "wear-land", &[1.0]);
        let expected = 2.0 * 200.0 * 10f64.to_radians().tan();
        assert!((1e6 * unloaded(shift.machine(), &moment()).unwrap() - expected).abs() < 1e-9);
    }
}
