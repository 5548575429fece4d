//! Play of worm and wheel, or of gears, that a reversal has to take up.
//!
//! On the way forwards the table stands where it should, on the way back it is farther on by gap (rad), as a slide with play
//! in its nut is [seed 000, fig. 2a]. A control adds its compensation at every reversal; where that is more than the play
//! the table runs ahead on the way back, and gap, which is what is left of the two, is below zero. A torque that is larger
//! than friction keeps the table on one flank, and play shows no more (`forward`); what a control then still adds at a
//! reversal is left out. So is play that differs round the wheel (`uneven-backlash`).

use super::super::machine::Effect;
use super::needs::teeth;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::SMALL_ANGLE;

/// `backlash`.
pub static BACKLASH: Effect<1> = Effect {
    name: "backlash",
    about: "play that each reversal takes up; below zero where the controller compensates more than there is",
    law: "deviation += gap, on the flank that drives in -: where torque + friction*sign > 0, sign -1 in +, +1 in -",
    source: "seed 000, fig. 2a, with angles",
    belongs: Belongs::Test,
    odds: Odds::of(1.0, "worms and gears need play to turn, and compensation is never exact"),
    parameters: [Parameter::signed("gap", SMALL_ANGLE, "play in all, less what is compensated", (-120.0, 600.0))],
    look_alikes: &[
        ("elastic-wind-up", "a torque beyond friction: play shows no more, and the drive gives way as before"),
        ("uneven-backlash", "targets all round, from both sides"),
        ("reference-shift", "approaches from both sides: play is of one of them"),
        ("thermal-drift", "the order of approaches: + always before - lets drift pass for play"),
    ],
    needs: teeth,
    act: |[gap], machine| machine.gap += gap,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    const PLAY: (&str, &str, &[f64]) = (WORM, "backlash", &[40.0]);

    #[test]
    fn only_the_way_back_is_off() {
        let [there, back] = both(PLAY, 120.0);
        assert!(there == 0.0 && near(back, 40.0));
        assert!(near(both((WORM, "backlash", &[-25.0]), 120.0)[1], -25.0));
    }

    #[test]
    fn a_torque_keeps_the_table_on_one_flank() {
        assert_eq!(turned(PLAY, 120.0, -5.0), [0.0, 0.0]);
        assert!(turned(PLAY, 120.0, 5.0).iter().all(|deviation| near(*deviation, 40.0)));
    }
}
