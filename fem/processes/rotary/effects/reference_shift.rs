//! The reference point is off.
//!
//! The same offset (rad) everywhere: the reference mark or switch, or where the comparison was set to zero. ISO 230-2
//! quantities do not see it.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::SMALL_ANGLE;

/// `reference-shift`.
pub static REFERENCE_SHIFT: Effect<1> = Effect {
    name: "reference-shift",
    about: "the reference point is off",
    law: "deviation += offset",
    source: "seed 001, readings from a reference point",
    belongs: Belongs::Test,
    odds: Odds::of(0.7, "a zero is set once for a test, and an arc second is little"),
    parameters: [Parameter::signed("offset", SMALL_ANGLE, "of the reference point", (-300.0, 300.0))],
    look_alikes: &[
        ("worm-error", "targets that are no multiples of a turn of the worm: only there its error varies"),
        (
            "worm-second-harmonic",
            "targets that are no multiples of half a turn of the worm: only there its error varies",
        ),
        ("tooth-error", "targets that are no multiples of a tooth: only there its error varies"),
        ("gear-eccentricity", "targets that are no multiples of a turn of the pinion: only there its error varies"),
        (
            "motor-gear-eccentricity",
            "targets that are no multiples of a turn of the motor: only there its error varies",
        ),
        ("interpolation-error", "targets that are no multiples of a line: only there its error varies"),
        ("elastic-wind-up", "approaches from both sides: friction holds the table back either way, an offset does not"),
        ("backlash", "approaches from both sides: play is of one of them"),
        ("thermal-drift", "cold and warm: only drift follows the time"),
    ],
    needs: nothing,
    act: |[offset], machine| machine.add(move |_, _| offset),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn everything_is_shifted() {
        assert!(both((WORM, "reference-shift", &[-4.5]), 123.0).iter().all(|value| near(*value, -4.5)));
    }
}
