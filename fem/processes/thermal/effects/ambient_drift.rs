//! The room warms and cools.
//!
//! T_a = T₀ + A·[sin(2πt/period + phase) − sin phase], A the amplitude (K), from T₀ at the start:
//! day and night, or a heating that switches. A record of the room's temperature stands in the place of T₀.
//! It is felt only through what loses heat: convection, the base, edges of a plane body that lose to the
//! environment.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::solve::rod::Swing;
use crate::units::{ANGLE, PERIOD, TEMPERATURE_RISE};

/// `ambient-drift`.
pub static AMBIENT_DRIFT: Effect<3> = Effect {
    name: "ambient-drift",
    about: "the surroundings warm and cool in waves",
    law: "T_a = T_0 + amplitude*(sin(2*pi*t/period + phase) - sin(phase))",
    source: "first harmonic of the room's temperature",
    belongs: Belongs::Test,
    odds: Odds::of(0.3, "rooms swing, but for a short test by little"),
    parameters: [
        Parameter::amplitude("amplitude", TEMPERATURE_RISE, "half of the swing", (0.2, 10.0)),
        Parameter::shape("period", PERIOD, "from crest to crest", (0.5, 24.0)),
        Parameter::phase("phase", ANGLE, "of the wave at the start", 360.0),
    ],
    look_alikes: &[("extra-source", "another run, at another time of day")],
    needs: nothing,
    act: |[amplitude, period, phase], machine| {
        machine.drifts.push(Swing { size: amplitude, omega: std::f64::consts::TAU / period, phase });
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_room_starts_as_the_model_says_and_is_felt_only_through_losses() {
        let drift = "ambient-drift = { amplitude = '3 K', period = '2 h', phase = '70 deg' }";
        let lossy = "convection = { coefficient = '20 W/m^2/K' }";
        let heated = rod(drift);
        assert_eq!(heated.machine().around().at(0.0), 0.0);
        let quarter = 1800.0;
        let expected = 3.0 * (160f64.to_radians().sin() - 70f64.to_radians().sin());
        assert!((heated.machine().around().at(quarter) - expected).abs() < 1e-12);
        let middle = |effects: &str| rise(&rod(effects), 0.1, 5000.0);
        assert!((middle(drift) - middle("")).abs() < 1e-12, "insulated");
        assert!((middle(&format!("{lossy}\n{drift}")) - middle(lossy)).abs() > 0.1);
    }
}
