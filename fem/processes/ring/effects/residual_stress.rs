//! The blank's own stresses are set free by boring.
//!
//! A rolled or forged ring holds stresses that boring takes out of balance; released it goes oval by
//! A·cos 2(θ − orientation − phase), A the amplitude (m). The oval is fast to the ring: it turns with the
//! ring's mark, which stands at `orientation` from jaw 1 (rad). An oval alone; only of the released ring.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{ANGLE, MICRO};

/// `residual-stress`.
pub static RESIDUAL_STRESS: Effect<2> = Effect {
    name: "residual-stress",
    about: "stresses of the blank are set free by the cut, and the ring goes oval",
    law: "deviation += amplitude*cos(2*(theta - orientation - phase)), released",
    source: "relaxation of residual stress in its lowest harmonic",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "rolled and forged rings have it"),
    parameters: [
        Parameter::amplitude("amplitude", MICRO, "half of peak to valley of the oval", (0.5, 50.0)),
        Parameter::phase("phase", ANGLE, "where its crest stands from the ring's mark", 180.0),
    ],
    look_alikes: &[
        ("spindle-error", "the ring turned in the chuck: residual stress turns with it"),
        ("jaw-position", "a second jaw force"),
        ("jaw-imbalance", "a second jaw force, or the ring turned in the chuck: residual stress turns with it"),
        ("copying", "another blank: a copy follows it"),
    ],
    needs: nothing,
    act: |[amplitude, phase], machine| {
        machine.add_released(move |at| amplitude * (2.0 * (at.angle - at.orientation - phase)).cos());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_oval_turns_with_the_ring() {
        assert!((mark("residual-stress", &[4.0, 20.0], 50.0, 30.0) - 4.0).abs() < 1e-12);
        assert!((mark("residual-stress", &[4.0, 20.0], 50.0, 0.0) - 4.0 * 60f64.to_radians().cos()).abs() < 1e-12);
    }
}
