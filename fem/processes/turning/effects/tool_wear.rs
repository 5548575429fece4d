//! The tool wears: the edge draws back, and parts grow.
//!
//! ΔD += 2·U(ℓ), U = run_in·(1 − e^(−ℓ/run_in_path)) + rate·ℓ [seed 002 (31), (32)], ℓ the cutting path
//! since the batch began (m). The first term is the running-in, the second the steady wear; the third period, in
//! which the edge breaks down, is `tool-breakdown`.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{MICRO, PATH, WEAR_RATE};

/// `tool-wear`.
pub static TOOL_WEAR: Effect<3> = Effect {
    name: "tool-wear",
    about: "the cutting edge wears back along the cutting path, and parts grow",
    law: "dD += 2*U, U = run_in*(1 - exp(-l/run_in_path)) + rate*l",
    source: "seed 002 (31), (32)",
    belongs: Belongs::Test,
    odds: Odds::of(1.0, "every edge wears"),
    parameters: [
        Parameter::amplitude("run_in", MICRO, "wear of the running-in", (0.5, 20.0)).or(0.0),
        Parameter::shape("run_in_path", PATH, "path of the running-in", (50.0, 2000.0)).needed_with("run_in"),
        Parameter::amplitude("rate", WEAR_RATE, "steady wear per cutting path", (0.5, 50.0)),
    ],
    look_alikes: &[
        ("tool-thermal-growth", "a pause: wear stays, growth goes back"),
        ("tool-breakdown", "more parts before and after the onset: steady wear grows from the first part on"),
        ("spindle-thermal-drift", "a pause with the spindle off, and x: drift fades toward the tailstock"),
        ("wear-land", "the width of the land, measured with a microscope between more parts"),
    ],
    needs: nothing,
    act: |[run_in, run_in_path, rate], machine| {
        machine.add_wear(move |path| run_in * -(-path / run_in_path).exp_m1() + rate * path)
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn wear_follows_the_path() {
        // 800 m: 2·(2·(1 − e⁻²) + 8·0.8) um.
        let expected = 2.0 * (2.0 * (1.0 - (-2f64).exp()) + 6.4);
        assert!((shift("tool-wear", &[2.0, 400.0, 8.0], moment()) - expected).abs() < 1e-12);
    }
}
