//! The zero of the axis wanders as it warms.
//!
//! size·(1 − e^(−t/τ)), size (rad) what the drift tends to, τ its time constant (s), t the time since the test began with a
//! cold axis: the worm grows along itself from its fixed bearing and turns the wheel, the housing twists against the
//! instrument. The same at every angle. Negative where it goes backwards. Left out: cooling in pauses.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{SMALL_ANGLE, TIME};

/// `thermal-drift`.
pub static THERMAL_DRIFT: Effect<2> = Effect {
    name: "thermal-drift",
    about: "the zero of the axis wanders as the axis warms",
    law: "deviation += size*(1 - exp(-time/time_constant))",
    source: "first order in time; ISO 230-3, drift of an axis that warms",
    belongs: Belongs::Test,
    odds: Odds::of(0.4, "worms run warm, and most of it shows at all angles alike"),
    parameters: [
        Parameter::signed("size", SMALL_ANGLE, "of the drift of the warm axis", (-120.0, 120.0)),
        Parameter::shape("time_constant", TIME, "time constant of the warming", (5.0, 120.0)),
    ],
    look_alikes: &[
        ("reference-shift", "cold and warm: only drift follows the time"),
        ("ratio-error", "angles in another order: a ratio follows the angle, drift the time"),
        ("backlash", "the order of approaches: + always before - lets drift pass for play"),
    ],
    needs: nothing,
    act: |[size, time_constant], machine| {
        machine.add(move |_, time| -size * (-time / time_constant).exp_m1());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;
    use crate::positioning::Direction;

    #[test]
    fn it_goes_with_the_time_at_all_angles_alike() {
        let at = |angle, minutes| {
            deviation((WORM, "thermal-drift", &[10.0, 20.0]), angle, Direction::Backward, minutes, 0.0)
        };
        assert!(at(300.0, 0.0) == 0.0 && near(at(0.0, 1e6), 10.0));
        assert!(near(at(50.0, 20.0), 10.0 * (1.0 - (-1.0f64).exp())));
    }
}
