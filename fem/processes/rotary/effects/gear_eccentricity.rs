//! The pinion of the last pair of gears runs out.
//!
//! A·sin(iθ + phase), A in rad at the table, i the turns of that pinion in one of the table: the ratio of the pair, times
//! that of a worm that follows. A pinion off its axis by e (m) moves the pitch line by e, and a gear of pitch radius r by e/r.
//! Left out: what the shaft before it adds (`motor-gear-eccentricity`), and middle shafts of three stages and more, whose
//! errors the ratios behind them make smaller.

use super::super::machine::Effect;
use super::needs::gears;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, SMALL_ANGLE};

/// `gear-eccentricity`.
pub static GEAR_ECCENTRICITY: Effect<2> = Effect {
    name: "gear-eccentricity",
    about: "the pinion of the last pair of gears is off its axis",
    law: "deviation += amplitude*sin(i*angle + phase), i = driven/driving of the last of drive.stages, times teeth/starts of a worm behind it",
    source: "geometry of an eccentric circle, first order in e/r",
    belongs: Belongs::Test,
    odds: Odds::of(0.7, "pinions run out by some micrometres, and their wheels are small"),
    parameters: [
        Parameter::amplitude("amplitude", SMALL_ANGLE, "half of peak to valley, at the table", (0.5, 600.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[
        ("tooth-error", "targets closer than a tooth: far apart, one wave passes for another"),
        ("motor-gear-eccentricity", "targets that share a turn of the motor into more than two parts"),
        ("reference-shift", "targets that are no multiples of a turn of the pinion: only there its error varies"),
    ],
    needs: gears,
    act: |[amplitude, phase], machine| {
        let turns = machine.setup.drive.turns_of_pinion().unwrap_or(0.0);
        machine.add(move |angle, _| amplitude * (turns * angle + phase).sin());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_comes_back_with_every_turn_of_the_last_pinion() {
        // 20:100, a turn is 72 degrees of the table.
        let at = |angle| both((TRAIN, "gear-eccentricity", &[40.0, 90.0]), angle);
        assert!(
            near(at(0.0)[0], 40.0) && near(at(72.0)[1], 40.0) && near(at(108.0)[0], -40.0) && near(at(18.0)[0], 0.0)
        );
    }
}
