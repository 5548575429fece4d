//! The front guideway wears faster than the rear one, and the carriage tilts.
//!
//! The front guideway of a lathe wears about five times as much as the rear one, most at some distance from the
//! headstock [seed 002, wear of the guideways]. Where the front has sunk by U(x) and the rear by U/5, a carriage on
//! guideways b apart tilts to the front by (U − U/5)/b, and its nose, at the centre height H above them, leaves the
//! axis by Δy = 0.8·U·H/b: ΔD += 2·Δy, U(x) = wear·exp(−((x − centre)/width)²/2). The seed draws the scheme and
//! prints no formula: Δy is ours, by geometry. All lengths in m. Left out: the nose's fall by the mean sinking, which
//! changes the diameter by its square alone.

use super::super::machine::Effect;
use super::super::setup::Setup;
use super::guideway_wear::{LEVEL, part};
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{LENGTH, MICRO};

/// Wear of the front guideway over that of the rear one.
const FRONT_OVER_REAR: f64 = 5.0;

/// `front-guideway-wear`.
pub static FRONT_GUIDEWAY_WEAR: Effect<3> = Effect {
    name: "front-guideway-wear",
    about: "the front guideway is worn five times as much as the rear one, and the carriage tilts there",
    law: "dD += 2*0.8*U*H/b, U = wear*exp(-((x - centre)/width)^2/2), H = workholding.centre_height, b = workholding.guideway_spacing",
    source: "geometry, ours; the ratio of five by seed 002, wear of the guideways",
    belongs: Belongs::Machine,
    odds: Odds::of(0.1, "worn beds are old ones"),
    parameters: [
        Parameter::amplitude("wear", MICRO, "wear of the front guideway at its worst place", (1.0, 200.0)),
        Parameter::place("centre", LENGTH, "the worst place, from the headstock", "x", (0.0, 1000.0)),
        Parameter::shape("width", LENGTH, "standard width of the worn place", (10.0, 300.0)),
    ],
    look_alikes: &[("guideway-wear", LEVEL), ("bed-sag", "a level along the guideways: wear stands at one place")],
    needs: two_guideways,
    act: |[wear, centre, width], machine| {
        let Some(spacing) = machine.setup.guideway_spacing else { return };
        let lever = (1.0 - 1.0 / FRONT_OVER_REAR) * machine.setup.centre_height / spacing;
        machine.add_shift(move |at| 2.0 * lever * wear * part(at.x, centre, width));
    },
};

/// Checks the needs of effects that tilt the carriage: a guideway spacing.
pub fn two_guideways(setup: &Setup) -> Result<(), String> {
    match setup.guideway_spacing {
        Some(_) => Ok(()),
        None => Err("needs to know how far apart the guideways are: `guideway_spacing` in [workholding]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;
    use crate::process::with_effect;

    #[test]
    fn the_carriage_tilts_by_the_difference() {
        // 30 um at the front, 6 um at the rear, 300 mm apart: 80 um/m, and 250 mm above them 20 um.
        let text = model("centres").replace("type = \"centres\"", "type = \"centres\", guideway_spacing = \"300 mm\"");
        let worn = with_effect::<super::super::super::Turning>(&text, "front-guideway-wear", &[30.0, 150.0, 80.0]);
        assert!((1e6 * unloaded(worn.machine(), &moment()).unwrap() - 40.0).abs() < 1e-9);
    }
}
