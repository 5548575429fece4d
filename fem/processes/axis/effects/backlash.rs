//! Kinematic clearance: play in the nut and the bearings that a reversal has to take up.
//!
//! On the way forwards the slide stands where it should, on the way back it lags by δ = gap (m): y = x − δ
//! [seed 000, fig. 2a]. The same all along the screw. A controller adds its compensation at every reversal;
//! where that is more than the play the slide runs ahead on the way back, and δ, which is what is left of
//! the two, is below zero. A lost motion by a play angle φ of the guideways at a lever arm L is the same law,
//! δ = L·φ: tests on one line cannot tell the two. Left out: play that differs along the travel
//! (`uneven-backlash`, `worn-screw`).

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `backlash`.
pub static BACKLASH: Effect<1> = Effect {
    name: "backlash",
    about: "play that each reversal takes up; below zero where the controller compensates more than there is",
    law: "deviation += gap, approaching in -",
    source: "seed 000, fig. 2a",
    belongs: Belongs::Test,
    odds: Odds::of(1.0, "compensation is never exact"),
    parameters: [Parameter::signed("gap", MICRO, "clearance in all, less what is compensated", (-100.0, 200.0))],
    look_alikes: &[
        ("elastic-lost-motion", "targets from end to end of the screw: elastic clearance grows away from the bearing"),
        ("thermal-growth", "the order of approaches: + always before - lets drift pass for play"),
        ("uneven-backlash", "targets from end to end of the travel, from both sides"),
        ("worn-screw", "targets from end to end of the travel, from both sides"),
    ],
    needs: nothing,
    act: |[gap], machine| machine.gap += gap,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_slide_that_is_pulled_stays_on_one_flank() {
        // 500 N stretch 200 mm of the screw.
        let stretched = 1e6 * 500.0 * 0.2 / (210e9 * std::f64::consts::PI * 0.016 * 0.016);
        for deviation in pulled("backlash", &[8.0], 300.0, 500.0) {
            assert!((deviation + stretched).abs() < 1e-9, "{deviation} for -{stretched}");
        }
    }

    #[test]
    fn only_the_way_back_lags() {
        assert_eq!(both("backlash", &[8.0], 300.0), [0.0, 8.0]);
    }

    #[test]
    fn a_compensation_of_too_much_lets_the_way_back_run_ahead() {
        let [there, back] = both("backlash", &[-25.0], 300.0);
        assert!(there == 0.0 && (back + 25.0).abs() < 1e-9, "{there} {back}");
    }
}
