//! An error that comes back with every line of the scale.
//!
//! A·sin(Nθ + phase), A in rad at the table, N the lines that pass in a turn of the table: those of the ring, times the ratio
//! where the scale is on the motor. Signals of unequal size, with an offset or out of quadrature are interpolated wrongly
//! within each line. At targets that are multiples of a line it cannot be seen. Left out: its second harmonic.

use super::super::machine::Effect;
use super::super::scale::At;
use super::super::setup::Setup;
use super::needs::a_drive_that_shows;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, SMALL_ANGLE};

/// `interpolation-error`.
pub static INTERPOLATION_ERROR: Effect<2> = Effect {
    name: "interpolation-error",
    about: "an error that repeats with every line of the scale",
    law: "deviation += amplitude*sin(N*angle + phase), N = scale.lines, times the ratio of the drive where the scale is on the motor",
    source: "HEIDENHAIN, Position Encoders for Servo Drives, position error within one signal period",
    belongs: Belongs::Test,
    odds: Odds::of(0.4, "interpolation leaves about a hundredth of a line"),
    parameters: [
        Parameter::amplitude("amplitude", SMALL_ANGLE, "half of peak to valley, at the table", (0.05, 60.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[("reference-shift", "targets that are no multiples of a line: only there its error varies")],
    needs: lines,
    act: |[amplitude, phase], machine| {
        let lines = machine.setup.scale.and_then(|scale| scale.lines_a_turn(&machine.setup.drive)).unwrap_or(0.0);
        machine.add(move |angle, _| amplitude * (lines * angle + phase).sin());
    },
};

fn lines(setup: &Setup) -> Result<(), String> {
    let Some(scale) = setup.scale.filter(|scale| scale.lines.is_some()) else {
        return Err("needs a scale whose lines are told: `lines` in [scale]".into());
    };
    if scale.at == At::Motor { a_drive_that_shows(setup) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_comes_back_with_every_line() {
        // 3600 lines, a tenth of a degree each.
        let at = |angle| both((WORM, "interpolation-error", &[0.5, 0.0]), angle);
        assert!(
            near(at(0.025)[0], 0.5) && near(at(45.025)[1], 0.5) && near(at(45.075)[0], -0.5) && near(at(0.1)[0], 0.0)
        );
    }

    #[test]
    fn a_scale_on_the_motor_passes_by_the_ratio_faster() {
        let motor = TRAIN.to_string() + "scale = { at = \"motor\", lines = 100 }";
        // 2000 lines in a turn of the table.
        assert!(near(both((&motor, "interpolation-error", &[7.0, 0.0]), 0.045)[0], 7.0));
    }
}
