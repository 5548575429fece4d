//! The warming headstock moves the spindle off.
//!
//! The headstock stands off by d = drift·(1 − e^(−t/τ)), t since the batch began, and does not tilt; the tailstock
//! stays where it is. It stands there in the equilibrium of shaft and supports: between centres ΔD += 2d·(1 − x/L),
//! in a chuck the whole shaft goes along, ΔD += 2d, and between chuck and centre it bends, an even shaft in a stiff
//! chuck by ΔD += 2d·(1 − (3ξ² − ξ³)/2), ξ = x/L [seed 002 (8), (39); thermal deformation of the system]. It runs
//! through pauses: the spindle keeps turning. drift in m, of either sign; τ in s.

use super::super::machine::{Effect, Support};
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{MICRO, TIME};

/// `spindle-thermal-drift`.
pub static SPINDLE_THERMAL_DRIFT: Effect<2> = Effect {
    name: "spindle-thermal-drift",
    about: "the warming headstock moves the spindle away from the tool, or toward it",
    law: "d = drift*(1 - exp(-t/time_constant)); between centres dD += 2*d*(1 - x/L), in a chuck 2*d, between chuck and centre bent",
    source: "seed 002, thermal deformation of the system",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every headstock warms, unless it is warm already"),
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
        machine.displace(Support::Headstock, move |at| -drift * (-at.time / time_constant).exp_m1());
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn a_chuck_takes_the_shaft_along_and_a_centre_bends_it() {
        let drift = 2.0 * 6.0 * (1.0 - (-825f64 / 1800.0).exp());
        let [free, bent] =
            ["chuck", "chuck-and-centre"].map(|held| shift_in(held, "spindle-thermal-drift", &[6.0, 30.0], 0.3));
        assert!((free - drift).abs() < 1e-12 && (bent - drift * (1.0 - 0.5 * 0.625)).abs() < 1e-9);
    }

    #[test]
    fn drift_fades_toward_the_tailstock() {
        let expected = 2.0 * 6.0 * (1.0 - (-825f64 / 1800.0).exp()) * 0.75;
        assert!((shift("spindle-thermal-drift", &[6.0, 30.0], moment()) - expected).abs() < 1e-12);
    }
}
