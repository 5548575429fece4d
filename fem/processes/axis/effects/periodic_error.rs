//! An error that comes back with every turn of the screw.
//!
//! A·sin(2πx/lead + phase), A in m. Eccentric bearings, the screw's own drunkenness and interpolation errors
//! of an encoder on the screw repeat each turn. At targets that are multiples of the lead it is the same
//! everywhere and cannot be seen. Left out: harmonics of the turn.

use std::f64::consts::TAU;

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{ANGLE, MICRO};

/// `periodic-error`.
pub static PERIODIC_ERROR: Effect<2> = Effect {
    name: "periodic-error",
    about: "an error that repeats with every turn of the screw",
    law: "deviation += amplitude*sin(2*pi*position/lead + phase)",
    source: "seed 000, periodic error within a pitch",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every screw and every encoder has one"),
    parameters: [
        Parameter::amplitude("amplitude", MICRO, "half of peak to valley", (0.2, 30.0)),
        Parameter::phase("phase", ANGLE, "of the sine at the position 0", 360.0),
    ],
    look_alikes: &[("reference-shift", "targets that are no multiples of the lead: only there a turn's error varies")],
    needs: nothing,
    act: |[amplitude, phase], machine| {
        let lead = machine.setup.lead;
        machine.add(move |position, _| amplitude * (TAU * (position / lead).fract() + phase).sin());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_comes_back_with_every_turn() {
        let at = |position| both("periodic-error", &[4.0, 30.0], position);
        for value in [at(0.0), at(10.0), at(320.0)].as_flattened() {
            assert!((value - 2.0).abs() < 1e-9);
        }
        assert!((at(2.5)[0] - 4.0 * 60f64.to_radians().sin()).abs() < 1e-9);
    }
}
