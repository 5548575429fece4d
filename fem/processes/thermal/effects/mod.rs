//! The effects of a heated body. One file and one line each.

mod ambient_drift;
mod base_conductance;
mod contact_resistance;
mod convection;
mod extra_source;
mod heater_capacity;
mod sensor_lag;

use super::machine::Machine;
use super::setup::Setup;
use crate::process::CatalogueEffect;

/// The registry.
pub const ALL: &[&dyn CatalogueEffect<Setup, Machine>] = &[
    &convection::CONVECTION,
    &base_conductance::BASE_CONDUCTANCE,
    &ambient_drift::AMBIENT_DRIFT,
    &extra_source::EXTRA_SOURCE,
    &heater_capacity::HEATER_CAPACITY,
    &contact_resistance::CONTACT_RESISTANCE,
    &sensor_lag::SENSOR_LAG,
];

#[cfg(test)]
mod bench {
    //! A rod to try effects on.

    use super::super::Thermal;
    use super::super::rows::{elongations, temperatures};
    use crate::process::{Assembled, ForwardModel, assembled};

    /// Ø20 × 200 mm of steel with 15 W at its free end for an hour and a half.
    const MODEL: &str = r#"
        body = { material = "steel", segments = [{ length = "200 mm", diameter = "20 mm" }] }
        source = [{ at = "200 mm", power = "15 W", on = [["0 min", "90 min"]] }]
        environment = { temperature = "20 degC" }
        time = { end = "180 min", step = "30 s" }
    "#;

    /// Length, m; k·A, W m/K; ρ·c·A·L, J/K; of the rod.
    pub const LENGTH: f64 = 0.2;
    pub fn conductance() -> f64 {
        50.0 * std::f64::consts::PI * 1e-4
    }
    pub fn capacity() -> f64 {
        7850.0 * 470.0 * std::f64::consts::PI * 1e-4 * LENGTH
    }

    /// The rod with effects as a model file has them.
    pub fn rod(effects: &str) -> Assembled<Thermal> {
        assembled(MODEL, effects).unwrap()
    }

    /// Rise (K) at x (m) and a time (s).
    pub fn rise(rod: &Assembled<Thermal>, x: f64, time: f64) -> f64 {
        rod.observe(&temperatures(&[[x, f64::NAN]], time)).unwrap()[0] - 293.15
    }

    /// Elongation (m) at a time (s).
    pub fn elongation(rod: &Assembled<Thermal>, time: f64) -> f64 {
        rod.observe(&elongations(&[time])).unwrap()[0]
    }
}
