//! The warming headstock moves the spindle off.
//!
//! ΔD += 2·drift·(1 − e^(−t/τ))·(1 − x/L), t since the batch began; the tailstock stays where it is, and in
//! a chuck without one the whole shaft moves: no (1 − x/L) [seed 002 (8), (39); thermal deformation of the
//! system]. It runs through pauses: the spindle keeps turning. drift in m, of either sign; τ in s.

use super::super::machine::Effect;
use crate::process::{Belongs, Parameter, nothing};
use crate::units::{MICRO, TIME};

/// `spindle-thermal-drift`.
pub static SPINDLE_THERMAL_DRIFT: Effect<2> = Effect {
    name: "spindle-thermal-drift",
    about: "the warming headstock moves the spindle away from the tool, or toward it",
    law: "dD += 2*drift*(1 - exp(-t/time_constant))*(1 - x/L); no (1 - x/L) in a chuck",
    source: "seed 002, thermal deformation of the system",
    belongs: Belongs::Test,
    parameters: [
        Parameter::signed("drift", MICRO, "final drift of the spindle", (-50.0, 50.0)),
        Parameter::shape("time_constant", TIME, "time constant of the headstock", (5.0, 240.0)),
    ],
    look_alikes: &[
        ("headstock-compliance", "more parts: drift grows with time"),
        ("tool-wear", "x: drift fades toward the tailstock, wear does not"),
    ],
    needs: nothing,
    act: |[drift, time_constant], machine| {
        let fixed_length = machine.setup.workholding.has_tailstock().then(|| machine.setup.length());
        machine.add_shift(move |at| {
            let lever = fixed_length.map_or(1.0, |length| 1.0 - at.x / length);
            2.0 * drift * -(-at.time / time_constant).exp_m1() * lever
        });
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn drift_fades_toward_the_tailstock() {
        let expected = 2.0 * 6.0 * (1.0 - (-825f64 / 1800.0).exp()) * 0.75;
        assert!((shift("spindle-thermal-drift", &[6.0, 30.0], moment()) - expected).abs() < 1e-12);
    }
}
