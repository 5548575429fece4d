//! The room warms and cools.
//!
//! T_a = T₀ + A·[sin(2πt/period + phase) − sin phase], A the amplitude (K), from T₀ at the start: day and night, or a heating that switches. It is felt
//! only through what loses heat: convection, the base, edges of a plane body that lose to the environment.

use super::super::{Drift, Machine};
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::{ANGLE, PERIOD, TEMPERATURE_RISE};

/// `ambient-drift`.
pub struct AmbientDrift;

static DESCRIPTION: Description = Description {
    name: "ambient-drift",
    about: "the surroundings warm and cool in waves",
    law: "T_a = T_0 + amplitude*(sin(2*pi*t/period + phase) - sin(phase))",
    source: "first harmonic of the room's temperature",
    parameters: &[
        Parameter::amplitude("amplitude", TEMPERATURE_RISE, "half of the swing", (0.2, 10.0)),
        Parameter::shape("period", PERIOD, "from crest to crest", (0.5, 24.0)),
        Parameter::phase("phase", ANGLE, "of the wave at the start", 360.0),
    ],
    look_alikes: &[("extra-source", "another run, at another time of day")],
};

impl Effect<Machine> for AmbientDrift {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        let omega = std::f64::consts::TAU / values["period"];
        machine.drifts.push(Drift { amplitude: values["amplitude"], omega, phase: values["phase"] });
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_room_starts_as_the_model_says_and_is_felt_only_through_losses() {
        let drift: (&str, &[f64]) = ("ambient-drift", &[3.0, 2.0, 70.0]);
        let heated = rod(&[drift]);
        assert_eq!(heated.machine.around(0.0), 0.0);
        let quarter = 1800.0;
        let expected = 3.0 * (160f64.to_radians().sin() - 70f64.to_radians().sin());
        assert!((heated.machine.around(quarter) - expected).abs() < 1e-12);
        assert!((rise(&heated, 0.1, 5000.0) - rise(&rod(&[]), 0.1, 5000.0)).abs() < 1e-12, "insulated");
        let lossy: (&str, &[f64]) = ("convection", &[20.0]);
        assert!((rise(&rod(&[lossy, drift]), 0.1, 5000.0) - rise(&rod(&[lossy]), 0.1, 5000.0)).abs() > 0.1);
    }
}
