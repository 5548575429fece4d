//! Thermometers are late.
//!
//! The temperature y that a sensor shows follows that of its place through a first-order lag, τ·y′ = T
//! − y from T₀ at the start, τ the time constant (s): the mass of the sensor and the paste below it.
//! All sensors have the same. The elongation is not concerned.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::SECONDS;

/// `sensor-lag`.
pub static SENSOR_LAG: Effect<1> = Effect {
    name: "sensor-lag",
    about: "temperature sensors show what was some time ago",
    law: "time_constant*dy/dt = T - y, y = T_0 at the start",
    source: "first-order instrument",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every sensor lags"),
    parameters: [Parameter::amplitude("time_constant", SECONDS, "of every temperature sensor", (5.0, 900.0))],
    look_alikes: &[
        ("contact-resistance", "the elongation, which no sensor delays"),
        ("heater-capacity", "the elongation, which no sensor delays"),
    ],
    needs: nothing,
    act: |[time_constant], machine| machine.lag = time_constant,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    /// The rise grows evenly once waves have settled; the sensor is then behind by its time constant.
    #[test]
    fn an_even_rise_is_shown_late_by_the_time_constant() {
        let (late, instant) = (rod("sensor-lag = { time_constant = '120 s' }"), rod(""));
        let behind = rise(&instant, 0.1, 5000.0) - rise(&late, 0.1, 5000.0);
        let slope = 15.0 / capacity();
        assert!((behind / (120.0 * slope) - 1.0).abs() < 1e-3, "{behind}");
        assert_eq!(elongation(&late, 5000.0), elongation(&instant, 5000.0));
    }
}
