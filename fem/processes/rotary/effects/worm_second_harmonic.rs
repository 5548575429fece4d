//! An error that comes back twice with every turn of the worm.
//!
//! A·sin(2·2πnθ/360° + phase), A in rad, n = teeth/starts the turns of the worm in one of the table: an oval worm, a
//! universal joint or a coupling out of line before it, two starts that differ. At targets that are multiples of half a
//! turn of the worm it cannot be seen.

use super::super::machine::Effect;
use super::needs::a_worm;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, SMALL_ANGLE};

/// `worm-second-harmonic`.
pub static WORM_SECOND_HARMONIC: Effect<2> = Effect {
    name: "worm-second-harmonic",
    about: "an error that repeats twice with every turn of the worm",
    law: "deviation += amplitude*sin(2*n*angle + phase), n = drive.teeth/drive.starts",
    source: "kinematics of an oval worm, or of a coupling out of line",
    belongs: Belongs::Test,
    odds: Odds::of(0.4, "it is smaller than the first of most worms"),
    parameters: [
        Parameter::amplitude("amplitude", SMALL_ANGLE, "half of peak to valley", (0.2, 60.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[
        ("worm-error", "targets that share a turn of the worm into more than two parts"),
        ("reference-shift", "targets that are no multiples of half a turn of the worm: only there its error varies"),
    ],
    needs: a_worm,
    act: |[amplitude, phase], machine| {
        let turns = 2.0 * machine.setup.drive.turns_of_worm().unwrap_or(0.0);
        machine.add(move |angle, _| amplitude * (turns * angle + phase).sin());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_comes_back_with_every_half_turn_of_the_worm() {
        let at = |angle| both((WORM, "worm-second-harmonic", &[3.0, 90.0]), angle);
        assert!(near(at(0.0)[0], 3.0) && near(at(1.0)[1], 3.0) && near(at(0.5)[0], -3.0) && near(at(89.25)[0], 0.0));
    }
}
