//! The gear on the motor of a train of two stages or more runs out.
//!
//! A·sin(nθ + phase), A in rad at the table, n the turns of the motor in one of the table. Of one stage the gear on the motor
//! is its pinion, which `gear-eccentricity` tells.

use super::super::machine::Effect;
use super::super::setup::Setup;
use super::needs::gears;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, SMALL_ANGLE};

/// `motor-gear-eccentricity`.
pub static MOTOR_GEAR_ECCENTRICITY: Effect<2> = Effect {
    name: "motor-gear-eccentricity",
    about: "the gear on the motor of a train of several stages is off its axis",
    law: "deviation += amplitude*sin(n*angle + phase), n = product of driven/driving over drive.stages, times teeth/starts of a worm behind them",
    source: "geometry of an eccentric circle, first order in e/r",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "the ratios behind it make it small"),
    parameters: [
        Parameter::amplitude("amplitude", SMALL_ANGLE, "half of peak to valley, at the table", (0.5, 300.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[
        ("gear-eccentricity", "targets that share a turn of the motor into more than two parts"),
        ("reference-shift", "targets that are no multiples of a turn of the motor: only there its error varies"),
    ],
    needs: several_stages,
    act: |[amplitude, phase], machine| {
        let turns = machine.setup.drive.ratio();
        machine.add(move |angle, _| amplitude * (turns * angle + phase).sin());
    },
};

fn several_stages(setup: &Setup) -> Result<(), String> {
    gears(setup)?;
    match setup.drive.stages.len() {
        0 | 1 => Err("needs two stages of gears: of one the gear on the motor is that of `gear-eccentricity`".into()),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_comes_back_with_every_turn_of_the_motor() {
        // 4 times 5, 18 degrees of the table.
        let at = |angle| both((TRAIN, "motor-gear-eccentricity", &[10.0, 0.0]), angle);
        assert!(near(at(4.5)[0], 10.0) && near(at(94.5)[1], 10.0) && near(at(13.5)[0], -10.0));
    }
}
