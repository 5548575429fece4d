//! The scales of x and y show unequal lengths.
//!
//! x(1 + m/2), y(1 − m/2): (m·R/2)·cos 2α on a circle, an ellipse along the axes. What both scales have in common is left out.

use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::SLOPE;

/// `scale-mismatch`.
pub struct ScaleMismatch;

static DESCRIPTION: Description = Description {
    name: "scale-mismatch",
    about: "one axis travels farther than the other for the same command, and a circle becomes an ellipse along the axes",
    law: "x*(1 + mismatch/2), y*(1 - mismatch/2): (mismatch*R/2)*cos(2*alpha)",
    source: "geometry of two axes",
    parameters: &[Parameter::signed("mismatch", SLOPE, "travel of x over that of y", (-200.0, 200.0))],
    look_alikes: &[],
};

impl Effect<Machine> for ScaleMismatch {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        let half = 0.5 * values["mismatch"];
        machine.scales = [1.0 + half, 1.0 - half];
    }
}

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
