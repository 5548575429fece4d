//! An axis is wrong by a wave over each turn of its screw or each period of its scale.
//!
//! position += amplitude·sin(2π·position/lead + phase), the position counted from the contour's centre. On a straight side at φ to the axis the wave is
//! lead/cos φ long [seed 000].

use super::super::Machine;
use super::super::machine::Cyclic;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::{ANGLE, MICRO};

/// `cyclic-error-x`, `cyclic-error-y`.
pub struct CyclicError {
    axis: usize,
    description: &'static Description,
}

/// Of the x axis.
pub static X: CyclicError = CyclicError { axis: 0, description: &DESCRIPTION_X };
/// Of the y axis.
pub static Y: CyclicError = CyclicError { axis: 1, description: &DESCRIPTION_Y };

static DESCRIPTION_X: Description = describe("cyclic-error-x", "x is wrong by a wave over each turn of its screw");
static DESCRIPTION_Y: Description = describe("cyclic-error-y", "y is wrong by a wave over each turn of its screw");
const PARAMETERS: &[Parameter] = &[
    Parameter::amplitude("amplitude", MICRO, "half of peak to valley", (0.2, 50.0)),
    Parameter::phase("phase", ANGLE, "at the contour's centre", 360.0),
];

const fn describe(name: &'static str, about: &'static str) -> Description {
    Description {
        name,
        about,
        law: "position += amplitude*sin(2*pi*position/lead + phase), lead = drives.lead",
        source: "seed 000 (error within the period of the feedback)",
        parameters: PARAMETERS,
        look_alikes: &[],
    }
}

impl Effect<Machine> for CyclicError {
    fn description(&self) -> &'static Description {
        self.description
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        machine.cyclic[self.axis] = Cyclic { amplitude: values["amplitude"], phase: values["phase"] };
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_wave_counts_from_the_centre() {
        // At 0 deg x is 150 mm less the contraction of 0.37 um: fifteen turns of 10 mm.
        for direction in DIRECTIONS {
            assert!((change("cyclic-error-x", &[2.0, 30.0], direction, 0.0) - 1.0).abs() < 1e-3);
            assert!((change("cyclic-error-y", &[2.0, 90.0], direction, 90.0) - 2.0).abs() < 1e-3);
        }
    }
}
