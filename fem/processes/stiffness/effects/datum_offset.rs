//! The gauge does not show zero where the joint stands without force.
//!
//! y += offset in every reading, on loading and unloading alike: the gauge was set to zero under a first
//! load that seats the part, or moved before the first reading. offset in m, of either sign. It differs from
//! clearance only without force, where clearance is not taken up yet.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::MICRO;

/// `datum-offset`.
pub static DATUM_OFFSET: Effect<1> = Effect {
    name: "datum-offset",
    about: "the gauge was not at zero before loading: all readings are off by the same",
    law: "y += offset, at F = 0 too",
    source: "load tests under a seating load; the zero of the displacement is that of the gauge",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "a gauge is set to zero by hand"),
    parameters: [Parameter::signed("offset", MICRO, "reading without force, before loading", (-200.0, 200.0))],
    look_alikes: &[
        ("gap", "a reading without force before loading: clearance is not taken up there"),
        ("contact-joint", "small forces: a contact closes little by little"),
    ],
    needs: nothing,
    act: |[offset], machine| machine.curve.offset += offset,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn every_reading_is_off() {
        for (force, branch) in [(0.0, Load), (400.0, Load), (400.0, Unload), (0.0, Unload)] {
            assert!((displacement("datum-offset", &[-3.0], force, branch) - (force / 80.0 - 3.0)).abs() < 1e-9);
        }
    }
}
