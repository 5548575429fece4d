//! The ratio between command and table is off all along.
//!
//! slope·θ, slope in rad/rad: a friction or belt drive whose ratio is a diameter, steps a degree that are rounded in the
//! control, a scale of a limited range that is stretched. At the angle 0 nothing is wrong, wherever the range begins. Over a
//! whole turn teeth and lines close, and an error that grows with the angle cannot be: it is refused there.

use std::f64::consts::TAU;

use super::super::machine::Effect;
use super::super::setup::Setup;
use super::needs::a_drive_that_shows;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, ANGLE_SLOPE};

/// `ratio-error`.
pub static RATIO_ERROR: Effect<1> = Effect {
    name: "ratio-error",
    about: "the ratio between command and table is off all along a limited range",
    law: "deviation += slope*angle",
    source: "kinematics; ISO 230-2, systematic error that is straight",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "teeth are whole numbers, and steps a degree are rounded"),
    parameters: [Parameter::signed("slope", ANGLE_SLOPE, "error per angle", (-5.0, 5.0))],
    look_alikes: &[
        ("thermal-drift", "angles in another order: a ratio follows the angle, drift the time"),
        ("wheel-eccentricity", "more of a turn: a part of a sine is nearly straight"),
        ("scale-eccentricity", "more of a turn: a part of a sine is nearly straight"),
    ],
    needs: an_open_range,
    act: |[slope], machine| machine.add(move |angle, _| slope * angle),
};

fn an_open_range(setup: &Setup) -> Result<(), String> {
    if setup.range >= TAU * (1.0 - 1e-9) {
        let range = ANGLE.format(setup.range);
        return Err(format!("needs a range below 360 deg, and this one is {range}: a full turn closes"));
    }
    a_drive_that_shows(setup)
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_grows_in_proportion() {
        let at = |angle| both((TRAIN, "ratio-error", &[0.5]), angle);
        assert!(near(at(90.0)[0], 45.0) && near(at(180.0)[1], 90.0) && at(0.0) == [0.0, 0.0]);
    }
}
