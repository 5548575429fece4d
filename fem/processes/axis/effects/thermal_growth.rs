//! The screw warms as it works, and grows away from its fixed bearing.
//!
//! slope·(1 − e^(−t/τ))·(x − fixed_at), slope (m/m) what the growth tends to, τ the time constant (s), t the
//! time since the test began with a cold axis. Negative where a warm axis cools. τ is that of a rod in air,
//! ρ·c·d/4h: 5 min for a screw of 30 mm at 100 W/m²K. Left out: cooling in pauses, and a screw that is
//! warmer in the middle.

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{SLOPE, TIME};

/// `thermal-growth`.
pub static THERMAL_GROWTH: Effect<2> = Effect {
    name: "thermal-growth",
    about: "the screw warms and grows away from its fixed bearing",
    law: "deviation += slope*(1 - exp(-time/time_constant))*(position - fixed_at)",
    source: "seed 002 (35)-(39), first order in time",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every screw warms when it runs"),
    parameters: [
        Parameter::signed("slope", SLOPE, "growth per length of the warm screw", (-200.0, 200.0)),
        Parameter::shape("time_constant", TIME, "time constant of the warming", (5.0, 120.0)),
    ],
    look_alikes: &[
        ("scale-error", "cold and warm: only growth follows the time"),
        ("backlash", "the order of approaches: + always before - lets drift pass for play"),
        ("uneven-backlash", "the order of approaches: + always before - lets growth pass for play"),
    ],
    needs: a_free_end,
    act: |[slope, time_constant], machine| {
        let fixed_at = machine.setup.fixed_at;
        machine.add(move |position, time| -slope * (-time / time_constant).exp_m1() * (position - fixed_at));
    },
};

fn a_free_end(setup: &Setup) -> Result<(), String> {
    match setup.also_fixed_at {
        Some(_) => Err("needs a screw that is free to grow, and this one is held by a bearing at either end".into()),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;
    use crate::positioning::Direction;

    #[test]
    fn it_grows_from_the_bearing_with_the_time() {
        let at = |position, minutes| deviation("thermal-growth", &[50.0, 20.0], position, Direction::Backward, minutes);
        assert_eq!(at(300.0, 0.0), 0.0);
        assert!((at(300.0, 20.0) - 10.0 * (1.0 - (-1.0f64).exp())).abs() < 1e-9);
        assert!((at(0.0, 1e6) + 5.0).abs() < 1e-9);
    }
}
