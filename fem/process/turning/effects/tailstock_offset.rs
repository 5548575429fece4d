//! The tailstock stands off the spindle axis.
//!
//! The work turns about a tilted line, ΔD += 2·offset·x/L. A chuck with a centre is taken as the same rigid tilt, without bending. Diameters alone cannot tell it
//! from a taper of the guideway. offset in m, away from the tool.

use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::MICRO;

/// `tailstock-offset`.
pub struct TailstockOffset;

static DESCRIPTION: Description = Description {
    name: "tailstock-offset",
    about: "the tailstock stands off the spindle axis, and the work turns about a tilted line",
    law: "dD += 2*offset*x/L",
    source: "statics; cf. seed 002 (6)",
    parameters: &[Parameter::signed("offset", MICRO, "offset of the tailstock away from the tool", (-100.0, 100.0))],
    look_alikes: &[
        ("guideway-taper", "an indicator on an unloaded sweep along the guideway; diameters alone cannot tell"),
        ("tailstock-compliance", "a second force"),
    ],
};

impl Effect<Machine> for TailstockOffset {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        let (offset, length) = (values["offset"], machine.setup.length());
        machine.shift(move |at| 2.0 * offset * at.x / length);
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_offset_tilts_the_axis() {
        assert!((shift("tailstock-offset", &[20.0], moment()) - 10.0).abs() < 1e-12);
    }
}
