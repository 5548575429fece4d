//! A drive sticks and slips all along the path.
//!
//! position += amplitude·sin(2πft + phase), f = `drives.frequency`, t since the lap began at 0°: a wave in
//! time, and along the path one of length λ = v/f, which grows with the feed [seed 000: an uneven wave
//! that depends on the feed; its first harmonic]. A cyclic error keeps the length of its lead. Left out:
//! the harmonics of the jerks, and that the wave begins anew with every lap.

use super::super::machine::{Cyclic, Effect, Machine};
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{ANGLE, MICRO};

/// `stick-slip-x`.
pub static X: Effect<2> = stick_slip(
    "stick-slip-x",
    "x sticks and slips at one frequency, and leaves a wave whose length follows the feed",
    &[("cyclic-error-x", FEED)],
    |[amplitude, phase], machine| machine.stick_slip[0] = Cyclic { amplitude, phase },
);
/// `stick-slip-y`.
pub static Y: Effect<2> = stick_slip(
    "stick-slip-y",
    "y sticks and slips at one frequency, and leaves a wave whose length follows the feed",
    &[("cyclic-error-y", FEED)],
    |[amplitude, phase], machine| machine.stick_slip[1] = Cyclic { amplitude, phase },
);

/// Measurement that separates a wave of the screw from one of stick-slip.
pub const FEED: &str =
    "another feed: a wave of the screw keeps its length, one of stick-slip is as much longer as the feed";

const fn stick_slip(
    name: &'static str,
    about: &'static str,
    look_alikes: &'static [(&'static str, &'static str)],
    act: fn([f64; 2], &mut Machine),
) -> Effect<2> {
    Effect {
        name,
        about,
        law: "position += amplitude*sin(2*pi*drives.frequency*t + phase): a wave of v/frequency along the path",
        source: "seed 000 (jerky drives); the line by hand",
        belongs: Belongs::Test,
        odds: Odds::of(0.1, "guideways are made against it"),
        parameters: [
            Parameter::amplitude("amplitude", MICRO, "half of peak to valley", (0.2, 50.0)),
            Parameter::phase("phase", ANGLE, "when the lap begins", 360.0),
        ],
        look_alikes,
        needs: a_frequency,
        act,
    }
}

fn a_frequency(setup: &Setup) -> Result<(), String> {
    match setup.frequency {
        Some(_) => Ok(()),
        None => Err("needs its frequency: frequency = \"5 Hz\" in [drives]".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_wave_is_one_of_time() {
        // 0.5 Hz; at 60 deg ccw 9·π/3 s have passed since the lap began.
        let since = 9.0 * std::f64::consts::PI / 3.0;
        let expected = 2.0 * (std::f64::consts::PI * since + 30f64.to_radians()).sin() * 60f64.to_radians().cos();
        assert!((change("stick-slip-x", &[2.0, 30.0], DIRECTIONS[0], 60.0) - expected).abs() < 2.0 / 400.0);
        // Clockwise five times as many.
        let expected = 2.0 * (5.0 * std::f64::consts::PI * since + 30f64.to_radians()).sin() * 60f64.to_radians().cos();
        assert!((change("stick-slip-x", &[2.0, 30.0], DIRECTIONS[1], 60.0) - expected).abs() < 2.0 / 400.0);
    }
}
