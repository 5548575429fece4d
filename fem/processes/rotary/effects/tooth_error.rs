//! An error that comes back with every tooth of the last pair of gears.
//!
//! A·sin(zθ + phase), A in rad at the table, z the meshes in a turn of the table: the teeth of the last gear, times the ratio
//! of a worm that follows. Flanks that are off their involute, or that bend as one and two teeth bear by turns, make the same
//! error at every mesh. At targets that are multiples of 360°/z it cannot be seen. Left out: meshes of other pairs, which the
//! ratios behind them make smaller, and teeth that differ.

use super::super::machine::Effect;
use super::needs::gears;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, SMALL_ANGLE};

/// `tooth-error`.
pub static TOOTH_ERROR: Effect<2> = Effect {
    name: "tooth-error",
    about: "an error that repeats with every tooth of the last pair of gears",
    law: "deviation += amplitude*sin(z*angle + phase), z = driven of the last of drive.stages, times teeth/starts of a worm behind it",
    source: "kinematics: transmission error at the frequency of the mesh",
    belongs: Belongs::Test,
    odds: Odds::of(0.7, "no flank is an involute to an arc second"),
    parameters: [
        Parameter::amplitude("amplitude", SMALL_ANGLE, "half of peak to valley, at the table", (0.5, 300.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the angle 0", 360.0),
    ],
    look_alikes: &[
        ("gear-eccentricity", "targets closer than a tooth: far apart, one wave passes for another"),
        ("reference-shift", "targets that are no multiples of a tooth: only there its error varies"),
    ],
    needs: gears,
    act: |[amplitude, phase], machine| {
        let meshes = machine.setup.drive.meshes().unwrap_or(0.0);
        machine.add(move |angle, _| amplitude * (meshes * angle + phase).sin());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_comes_back_with_every_tooth() {
        // 100 teeth, 3.6 degrees each.
        let at = |angle| both((TRAIN, "tooth-error", &[20.0, 0.0]), angle);
        assert!(near(at(0.9)[0], 20.0) && near(at(36.9)[1], 20.0) && near(at(2.7)[0], -20.0) && near(at(72.0)[0], 0.0));
    }
}
