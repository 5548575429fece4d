//! The reference point is off.
//!
//! The same offset (m) everywhere: the reference switch, or where the comparison was set to zero. ISO 230-2
//! quantities do not see it.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `reference-shift`.
pub static REFERENCE_SHIFT: Effect<1> = Effect {
    name: "reference-shift",
    about: "the reference point is off",
    law: "deviation += offset",
    source: "seed 001, readings from a reference point",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "a zero is set once for a test"),
    parameters: [Parameter::signed("offset", MICRO, "of the reference point", (-100.0, 100.0))],
    look_alikes: &[("periodic-error", "targets that are no multiples of the lead: only there a turn's error varies")],
    needs: nothing,
    act: |[offset], machine| machine.add(move |_, _| offset),
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn everything_is_shifted() {
        assert_eq!(both("reference-shift", &[-4.5], 123.0), [-4.5, -4.5]);
    }
}
