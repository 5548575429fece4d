//! Kinematic clearance: play in the nut and the bearings that a reversal has to take up.
//!
//! On the way forwards the slide stands where it should, on the way back it lags by δ = gap (m): y = x − δ
//! [seed 000, fig. 2a]. The same all along the screw. Left out: play that wear has made larger in the middle
//! of the screw.

use super::super::machine::Effect;
use crate::process::{Parameter, nothing};
use crate::units::MICRO;

/// `backlash`.
pub static BACKLASH: Effect<1> = Effect {
    name: "backlash",
    about: "play in nut and bearings that each reversal takes up",
    law: "deviation += gap, approaching in -",
    source: "seed 000, fig. 2a",
    parameters: [Parameter::amplitude("gap", MICRO, "clearance in all", (0.5, 200.0))],
    look_alikes: &[
        ("elastic-lost-motion", "targets from end to end of the screw: elastic clearance grows away from the bearing"),
        ("thermal-growth", "the order of approaches: + always before - lets drift pass for play"),
    ],
    needs: nothing,
    act: |[gap], machine| machine.gap += gap,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn only_the_way_back_lags() {
        assert_eq!(both("backlash", &[8.0], 300.0), [0.0, 8.0]);
    }
}
