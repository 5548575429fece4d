//! An error that comes back with every turn of the worm.
//!
//! A·sin(2πnθ/360° + phase), A in rad, n = teeth/starts the turns of the worm in one of the table. A worm that runs out, or
//! whose bearing lets it float along itself, moves the wheel to and fro once a turn: the periodic error of every worm drive.
//! At targets that are multiples of 360°/n it is the same everywhere and cannot be seen. Left out: harmonics
//! (`worm-second-harmonic`).

use super::super::machine::Effect;
use super::needs::a_worm;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, SMALL_ANGLE};

/// `worm-error`.
pub static WORM_ERROR: Effect<2> = Effect {
    name: "worm-error",
    about: "an error that repeats with every turn of the worm",
    law: "deviation += amplitude*sin(n*angle + phase), n = drive.teeth/drive.starts",
    source: "kinematics of a worm that runs out; ISO 230-2, periodic error",
    belongs: Belongs::Test,
    odds: Odds::of(1.0, "every worm has one that an arc second shows"),
    parameters: [
        Parameter::amplitude("amplitude", SMALL_ANGLE, "half of peak to valley", (0.2, 120.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[
        ("worm-second-harmonic", "targets that share a turn of the worm into more than two parts"),
        ("reference-shift", "targets that are no multiples of a turn of the worm: only there its error varies"),
    ],
    needs: a_worm,
    act: |[amplitude, phase], machine| {
        let turns = machine.setup.drive.turns_of_worm().unwrap_or(0.0);
        machine.add(move |angle, _| amplitude * (turns * angle + phase).sin());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_comes_back_with_every_turn_of_the_worm() {
        // A turn of the worm is 2 degrees of the table.
        let at = |angle| both((WORM, "worm-error", &[8.0, 30.0]), angle);
        for value in [at(0.0), at(2.0), at(346.0)].as_flattened() {
            assert!(near(*value, 4.0), "{value}");
        }
        assert!(near(at(0.5)[1], 8.0 * 120f64.to_radians().sin()));
    }
}
