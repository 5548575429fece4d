//! The tailstock stands off the spindle axis.
//!
//! The work turns about a tilted line, ΔD += 2·offset·x/L. A chuck with a centre is taken as the same rigid
//! tilt, without bending. Diameters alone cannot tell it from a taper of the guideway. offset in m, away
//! from the tool.

use super::super::machine::Effect;
use super::support_compliance::a_tailstock;
use crate::process::{Belongs, Parameter};
use crate::units::MICRO;

/// `tailstock-offset`.
pub static TAILSTOCK_OFFSET: Effect<1> = Effect {
    name: "tailstock-offset",
    about: "the tailstock stands off the spindle axis, and the work turns about a tilted line",
    law: "dD += 2*offset*x/L",
    source: "statics; cf. seed 002 (6)",
    belongs: Belongs::Test,
    parameters: [Parameter::signed("offset", MICRO, "offset of the tailstock away from the tool", (-100.0, 100.0))],
    look_alikes: &[
        ("guideway-taper", "an indicator on an unloaded sweep along the guideway; diameters alone cannot tell"),
        ("bed-twist", "a level that the carriage carries along the bed; diameters alone cannot tell"),
        ("tailstock-compliance", "a second force"),
    ],
    needs: a_tailstock,
    act: |[offset], machine| {
        let (offset, length) = (offset, machine.setup.length());
        machine.add_shift(move |at| 2.0 * offset * at.x / length);
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_offset_tilts_the_axis() {
        assert!((shift("tailstock-offset", &[20.0], moment()) - 10.0).abs() < 1e-12);
    }
}
