//! Whoever measures takes another centre than the one programmed.
//!
//! x·cos α + y·sin α on a circle: the set-up of the instrument, not an error of the machine.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `centre-offset`.
pub static CENTRE_OFFSET: Effect<2> = Effect {
    name: "centre-offset",
    about: "the contour lies beside the centre from which it is measured",
    law: "x*cos(alpha) + y*sin(alpha)",
    source: "set-up of the instrument (ISO 230-4)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "a ballbar is centred by hand"),
    parameters: [
        Parameter::signed("x", MICRO, "of the contour along x", (-100.0, 100.0)),
        Parameter::signed("y", MICRO, "of the contour along y", (-100.0, 100.0)),
    ],
    look_alikes: &[],
    needs: nothing,
    act: |[x, y], machine| machine.centre = [x, y],
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_circle_is_moved() {
        for direction in DIRECTIONS {
            for (angle, expected) in [(0.0, 3.0), (90.0, -4.0), (180.0, -3.0), (270.0, 4.0)] {
                // Across its own offset a circle moves by less than a nanometre, and by the lag of 1/450 rad.
                assert!((change("centre-offset", &[3.0, -4.0], direction, angle) - expected).abs() < 5.0 / 450.0);
            }
        }
    }
}
