//! The guideway is not parallel to the spindle axis.
//!
//! The slide leaves the axis by slope·x in the horizontal plane, and all of it shows: ΔD += 2·slope·x [seed
//! 002 (6)]. slope in m/m, of either sign.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::SLOPE;

/// `guideway-taper`.
pub static GUIDEWAY_TAPER: Effect<1> = Effect {
    name: "guideway-taper",
    about: "the guideway leaves the spindle axis in the horizontal plane",
    law: "dD += 2*slope*x",
    source: "seed 002 (6)",
    belongs: Belongs::Machine,
    odds: Odds::of(0.3, "guideways are aligned, but not for ever"),
    parameters: [Parameter::signed("slope", SLOPE, "slope of the guideway", (-200.0, 200.0))],
    look_alikes: &[
        ("tailstock-offset", "an indicator on an unloaded sweep along the guideway; diameters alone cannot tell"),
        ("bed-twist", "a level that the carriage carries along the bed; diameters alone cannot tell"),
        ("tailstock-compliance", "a second force"),
        ("workpiece-heating", "the pass reversed: heating follows the tool, a taper stays"),
        ("cross-slide-play", "more places in each section: a taper goes on within it, play does not"),
    ],
    needs: nothing,
    act: |[slope], machine| machine.add_shift(move |at| 2.0 * slope * at.x),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_taper_is_twice_the_slope() {
        assert!((shift("guideway-taper", &[20.0], moment()) - 6.0).abs() < 1e-12);
    }
}
