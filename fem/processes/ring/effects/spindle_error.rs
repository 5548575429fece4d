//! The spindle's axis moves twice in each turn.
//!
//! An error motion of the spindle of two waves a turn bores an oval A·cos 2(θ − phase), A the amplitude (m),
//! fast to the machine and so to jaw 1. It is cut into the bore, and the clamped ring that is not bored yet
//! does not show it. Once-a-turn motion only shifts the centre (`chuck-runout`); left out: other waves, and
//! motion that does not repeat.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{ANGLE, MICRO};

/// `spindle-error`.
pub static SPINDLE_ERROR: Effect<2> = Effect {
    name: "spindle-error",
    about: "the spindle's axis moves twice a turn, and cuts an oval",
    law: "deviation += amplitude*cos(2*(theta - phase)), cut",
    source: "radial error motion of two waves a turn, ISO 230-7",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every spindle has one"),
    parameters: [
        Parameter::amplitude("amplitude", MICRO, "half of peak to valley of the oval", (0.2, 20.0)),
        Parameter::phase("phase", ANGLE, "where its crest stands from jaw 1", 180.0),
    ],
    look_alikes: &[
        ("residual-stress", "the ring turned in the chuck: the spindle's oval stays with the machine"),
        ("jaw-position", "a second jaw force"),
        ("jaw-imbalance", "a second jaw force"),
        ("copying", "another blank: a copy follows it"),
    ],
    needs: nothing,
    act: |[amplitude, phase], machine| {
        machine.add_move(move |at| amplitude * (2.0 * (at.angle - phase)).cos());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_oval_stays_with_the_machine() {
        for orientation in [0.0, 30.0] {
            assert!((mark("spindle-error", &[4.0, 20.0], 20.0, orientation) - 4.0).abs() < 1e-12);
            assert!((mark("spindle-error", &[4.0, 20.0], 110.0, orientation) + 4.0).abs() < 1e-12);
        }
    }
}
