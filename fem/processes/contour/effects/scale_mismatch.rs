//! The scales of x and y show unequal lengths.
//!
//! x(1 + m/2), y(1 − m/2): (m·R/2)·cos 2α on a circle, an ellipse along the axes. What both scales have in
//! common is left out.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::SLOPE;

/// `scale-mismatch`.
pub static SCALE_MISMATCH: Effect<1> = Effect {
    name: "scale-mismatch",
    about: "one axis travels farther than the other for the same command, and a circle becomes an ellipse along the axes",
    law: "x*(1 + mismatch/2), y*(1 - mismatch/2): (mismatch*R/2)*cos(2*alpha)",
    source: "geometry of two axes",
    belongs: Belongs::Machine,
    odds: Odds::of(0.5, "no two scales are equal"),
    parameters: [Parameter::signed("mismatch", SLOPE, "travel of x over that of y", (-200.0, 200.0))],
    look_alikes: &[("cutting-deflection", "a lap without cutting: unequal scales stay")],
    needs: nothing,
    act: |[mismatch], machine| machine.scales = [1.0 + 0.5 * mismatch, 1.0 - 0.5 * mismatch],
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn x_grows_and_y_shrinks() {
        for direction in DIRECTIONS {
            assert!((change("scale-mismatch", &[40.0], direction, 0.0) - 3.0).abs() < 3.0 / 450.0);
            assert!((change("scale-mismatch", &[40.0], direction, 90.0) + 3.0).abs() < 3.0 / 450.0);
        }
    }
}
