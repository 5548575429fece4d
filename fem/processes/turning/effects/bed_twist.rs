//! The bed is twisted along its length.
//!
//! The guideways are level across at the headstock and tilt by φ(x) = twist·x along the bed. The carriage
//! tilts with them, and the tool nose, at the centre height H above them, leaves the axis by H·φ: ΔD +=
//! 2·H·twist·x [geometry of guideways; cf. seed 002 (6)]. twist in rad/m, of either sign; H in m. To
//! diameters it is exactly a guideway that is not parallel, and no diameter can tell the two; a level on the
//! carriage can. Left out: the nose's fall by H·φ²/2.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::TWIST;

/// `bed-twist`.
pub static BED_TWIST: Effect<1> = Effect {
    name: "bed-twist",
    about: "the bed is twisted along its length, and the tilting carriage moves the tool nose sideways",
    law: "dD += 2*H*twist*x, H = workholding.centre_height",
    source: "geometry of guideways; cf. seed 002 (6)",
    belongs: Belongs::Machine,
    odds: Odds::of(0.1, "beds are levelled"),
    parameters: [Parameter::signed("twist", TWIST, "tilt of the carriage per travel", (-200.0, 200.0))],
    look_alikes: &[
        ("guideway-taper", "a level that the carriage carries along the bed; diameters alone cannot tell"),
        ("tailstock-offset", "a level that the carriage carries along the bed; diameters alone cannot tell"),
        ("tailstock-compliance", "a second force"),
    ],
    needs: nothing,
    act: |[twist], machine| {
        let height = machine.setup.centre_height;
        machine.add_shift(move |at| 2.0 * height * twist * at.x);
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_nose_moves_by_the_tilt_at_its_height() {
        // 40 um/m/m over 0.15 m tilt the carriage by 6 um/m; 250 mm above the guideways that is 1.5 um.
        assert!((shift("bed-twist", &[40.0], moment()) - 3.0).abs() < 1e-12);
    }
}
