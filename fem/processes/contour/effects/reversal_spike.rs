//! An axis sticks for a moment when it turns round, and jumps after its command.
//!
//! After the axis turns round the tool stands outside the path by height·e^(−Δt/τ) along the axis, of which
//! |cos α| (x) or |sin α| (y) shows: Δt counts from where the axis turns round behind its servo and before
//! its play. Of earlier reversals nothing is kept.

use super::super::machine::{Effect, Machine, Spike};
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{MICRO, SHORT_TIME};

/// `reversal-spike-x`.
pub static X: Effect<2> = reversal_spike(
    "reversal-spike-x",
    "x sticks when it turns round, and leaves a spike that fades",
    "deviation += height*exp(-dt/time_constant)*|cos(alpha)|, dt since x turned round",
    |[height, time_constant], machine| machine.spikes[0] = Spike { height, time_constant },
);
/// `reversal-spike-y`.
pub static Y: Effect<2> = reversal_spike(
    "reversal-spike-y",
    "y sticks when it turns round, and leaves a spike that fades",
    "deviation += height*exp(-dt/time_constant)*|sin(alpha)|, dt since y turned round",
    |[height, time_constant], machine| machine.spikes[1] = Spike { height, time_constant },
);

const fn reversal_spike(
    name: &'static str,
    about: &'static str,
    law: &'static str,
    act: fn([f64; 2], &mut Machine),
) -> Effect<2> {
    Effect {
        name,
        about,
        law,
        source: "stick and slip at reversal (ISO 230-4)",
        belongs: Belongs::Test,
        odds: Odds::of(0.5, "friction holds an axis at its reversal"),
        parameters: [
            Parameter::amplitude("height", MICRO, "of the spike at the reversal", (0.5, 100.0)),
            Parameter::shape("time_constant", SHORT_TIME, "in which it fades", (10.0, 1000.0)),
        ],
        look_alikes: &[],
        needs: nothing,
        act,
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_spike_stands_behind_the_reversal() {
        // v/R = 1/9 rad/s, lag atan(1/450): at 5 deg x has turned round for so long, ccw.
        let since = (5f64.to_radians() - (1.0 / 450f64).atan()) * 9.0;
        let expected = 10.0 * (-since / 0.4).exp() * 5f64.to_radians().cos();
        assert!((change("reversal-spike-x", &[10.0, 400.0], DIRECTIONS[0], 5.0) - expected).abs() < 1e-9);
        // Clockwise 5 deg come before the reversal, 40 time constants after the last one.
        assert!(change("reversal-spike-x", &[10.0, 400.0], DIRECTIONS[1], 5.0) < 1e-9);
        let [ccw, cw] = DIRECTIONS.map(|d| change("reversal-spike-y", &[10.0, 400.0], d, 95.0));
        assert!((ccw - expected).abs() < 1e-9 && cw < 1e-9);
    }
}
