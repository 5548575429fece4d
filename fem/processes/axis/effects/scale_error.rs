//! The scale is wrong: the screw's lead or the encoder's pitch is off all along.
//!
//! slope·x, slope in m/m. At the position 0 nothing is wrong, wherever the travel begins.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::SLOPE;

/// `scale-error`.
pub static SCALE_ERROR: Effect<1> = Effect {
    name: "scale-error",
    about: "lead or scale is off all along the travel",
    law: "deviation += slope*position",
    source: "seed 001, pitch errors",
    belongs: Belongs::Test,
    odds: Odds::of(1.0, "no screw and no scale is exact"),
    parameters: [Parameter::signed("slope", SLOPE, "error per length", (-200.0, 200.0))],
    look_alikes: &[("thermal-growth", "cold and warm: growth follows the time, a scale does not")],
    needs: nothing,
    act: |[slope], machine| machine.add(move |position, _| slope * position),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_long_scale_overshoots_in_proportion() {
        assert_eq!(both("scale-error", &[20.0], 250.0), [5.0, 5.0]);
        assert_eq!(both("scale-error", &[20.0], -50.0), [-1.0, -1.0]);
    }
}
