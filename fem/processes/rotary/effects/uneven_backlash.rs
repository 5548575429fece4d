//! Play that comes and goes round the wheel.
//!
//! gap(θ) += change·cos(θ + phase) on the flank that drives backwards, change in rad: a wheel that runs out presses into the
//! worm on one side and leaves it on the other, and a wheel that is worn where it works has play there. None on the mean, so
//! that what is the same all round stays with `backlash`. First order of a play that depends on the angle, as the reversals
//! B_i of ISO 230-2 show it target by target. Left out: a table that binds where both together are below zero.

use super::super::machine::Effect;
use super::needs::teeth;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, SMALL_ANGLE};

/// `uneven-backlash`.
pub static UNEVEN_BACKLASH: Effect<2> = Effect {
    name: "uneven-backlash",
    about: "play changes once round the wheel",
    law: "deviation += change*cos(angle + phase), on the flank that drives in -",
    source: "ISO 230-2, reversal B_i at every target; first order round a turn",
    belongs: Belongs::Test,
    odds: Odds::of(0.4, "wheels run out, and wear where they are used most"),
    parameters: [
        Parameter::amplitude("change", SMALL_ANGLE, "half of the largest less the smallest play", (0.5, 120.0)),
        Parameter::phase("phase", ANGLE, "of the cosine at the angle 0", 360.0),
    ],
    look_alikes: &[
        ("backlash", "targets all round, from both sides"),
        ("unbalance", "a torque that keeps the table on one flank: play shows no more, what is out of balance does"),
    ],
    needs: teeth,
    act: |[change, phase], machine| machine.add_play(move |angle| change * (angle + phase).cos()),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_is_of_the_way_back_and_none_on_the_mean() {
        let at = |angle| both((WORM, "uneven-backlash", &[12.0, 60.0]), angle);
        assert!(at(77.0)[0] == 0.0 && near(at(0.0)[1], 6.0) && near(at(300.0)[1], 12.0) && near(at(120.0)[1], -12.0));
    }
}
