//! What an axis that lies carries is out of balance.
//!
//! T(θ) = M·cos(θ + phase), M = m·g·a (N·m) of a mass whose centre is a beside an axis across gravity [statics]: at the angle 0
//! it stands `phase` past the side on which its weight turns the table towards +, which is level with the axis. It is a
//! torque like any other: the drive gives way by T/k, and where it is larger than friction it carries the table from flank
//! to flank as it turns over (`forward`). Positive torques turn towards +. An axis along gravity has none. Left out: an axis
//! that is inclined, of which M is the part across gravity, and the bend of what is carried.

use super::super::machine::Effect;
use super::super::setup::{Orientation, Setup};
use super::needs::a_drive_that_shows;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, TORQUE};

/// `unbalance`.
pub static UNBALANCE: Effect<2> = Effect {
    name: "unbalance",
    about: "what a lying axis carries is out of balance, and its weight turns it",
    law: "torque += moment*cos(angle + phase); the drive gives way by torque/stiffness, and play is crossed where it turns over",
    source: "statics of a mass beside an axis",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "fixtures and parts are seldom balanced"),
    parameters: [
        Parameter::amplitude("moment", TORQUE, "weight times its distance from the axis", (0.5, 500.0)),
        Parameter::phase("phase", ANGLE, "of the cosine at the angle 0", 360.0),
    ],
    look_alikes: &[
        ("wheel-eccentricity", "another load or a counterweight: only what is out of balance changes with it"),
        ("scale-eccentricity", "another load or a counterweight: only what is out of balance changes with it"),
        (
            "uneven-backlash",
            "a torque that keeps the table on one flank: play shows no more, what is out of balance does",
        ),
    ],
    needs: an_axis_that_lies,
    act: |[moment, phase], machine| machine.add_torque(move |angle| moment * (angle + phase).cos()),
};

fn an_axis_that_lies(setup: &Setup) -> Result<(), String> {
    match setup.orientation {
        Orientation::Horizontal => a_drive_that_shows(setup),
        Orientation::Vertical => {
            Err("needs an axis across gravity: `orientation = \"horizontal\"` in [axis]; along it no weight turns"
                .into())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn its_weight_winds_the_drive_up() {
        // 30 N·m on 2 N·m/arcsec.
        let at = |angle| both((SPRUNG, "unbalance", &[30.0, 0.0]), angle);
        assert!(at(60.0).iter().all(|value| near(*value, 7.5)) && at(180.0).iter().all(|value| near(*value, -15.0)));
    }
}
