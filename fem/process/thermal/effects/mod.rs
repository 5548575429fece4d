//! The effects of a heated body. One file and one line each.

mod ambient_drift;
mod base_conductance;
mod contact_resistance;
mod convection;
mod extra_source;
mod sensor_lag;

use super::Machine;
use crate::process::Effect;

/// The registry.
pub const ALL: &[&dyn Effect<Machine>] = &[
    &convection::Convection,
    &base_conductance::BaseConductance,
    &ambient_drift::AmbientDrift,
    &extra_source::ExtraSource,
    &contact_resistance::ContactResistance,
    &sensor_lag::SensorLag,
];

#[cfg(test)]
mod bench {
    //! A rod to try effects on.

    use std::sync::Arc;

    use super::super::observe::{ELONGATION, TEMPERATURE_OF_ROW};
    use super::super::{Heated, Setup, effect};
    use crate::input::Reader;
    use crate::process::{Active, Job, Rows};

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

    /// The rod with some effects of these canonical values.
    pub fn rod(effects: &[(&str, &[f64])]) -> Heated {
        let model = toml_edit::Document::parse(MODEL).unwrap();
        let (setup, _, problems) = Reader::document(model.as_table(), Setup::read);
        assert_eq!(problems, []);
        let active = |(name, canonical): &(&str, &[f64])| {
            let description = effect(name).unwrap().description();
            let values = description.parameters.iter().zip(*canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
            Active { description, values, written: None }
        };
        Heated::equip(Arc::new(setup), &effects.iter().map(active).collect::<Vec<_>>())
    }

    /// Rise (K) at x (m) and a time (s).
    pub fn rise(rod: &Heated, x: f64, time: f64) -> f64 {
        let rows = Rows { columns: vec![vec![time], vec![x], vec![f64::NAN]], observable: vec![TEMPERATURE_OF_ROW] };
        rod.observe(&rows).unwrap()[0] - 293.15
    }

    /// Elongation (m) at a time (s).
    pub fn elongation(rod: &Heated, time: f64) -> f64 {
        let rows = Rows { columns: vec![vec![time], vec![f64::NAN], vec![f64::NAN]], observable: vec![ELONGATION] };
        rod.observe(&rows).unwrap()[0]
    }
}
