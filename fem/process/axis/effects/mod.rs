//! The effects of a feed axis. One file and one line each.

mod abbe_error;
mod backlash;
mod elastic_lost_motion;
mod periodic_error;
mod reference_shift;
mod scale_error;
mod thermal_growth;

use super::Machine;
use crate::process::Effect;

/// The registry.
pub const ALL: &[&dyn Effect<Machine>] = &[
    &scale_error::ScaleError,
    &periodic_error::PeriodicError,
    &backlash::Backlash,
    &elastic_lost_motion::ElasticLostMotion,
    &thermal_growth::ThermalGrowth,
    &abbe_error::AbbeError,
    &reference_shift::ReferenceShift,
];

#[cfg(test)]
mod bench {
    //! An axis to try effects on.

    use std::sync::Arc;

    use super::super::{Driven, Moment, Setup, effect};
    use crate::input::Reader;
    use crate::positioning::Direction;
    use crate::process::Active;

    /// 500 mm of travel on a steel screw of 32 mm and 10 mm a turn, held at 100 mm.
    const MODEL: &str = r#"
        axis = { travel = "500 mm" }
        screw = { material = "steel", diameter = "32 mm", lead = "10 mm", fixed_at = "100 mm" }
    "#;

    /// Deviation (um) with one effect of these canonical values, at a position (mm) forwards or backwards, after minutes.
    pub fn deviation(name: &str, canonical: &[f64], position: f64, direction: Direction, minutes: f64) -> f64 {
        let model = toml_edit::Document::parse(MODEL).unwrap();
        let (setup, _, problems) = Reader::document(model.as_table(), Setup::read);
        assert_eq!(problems, []);
        let description = effect(name).unwrap().description();
        let values = description.parameters.iter().zip(canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
        let axis = Driven::equip(Arc::new(setup), &[Active { description, values, written: None }]);
        1e6 * axis.deviation(&Moment { position: 1e-3 * position, direction, time: 60.0 * minutes })
    }

    /// The same forwards and backwards, cold.
    pub fn both(name: &str, canonical: &[f64], position: f64) -> [f64; 2] {
        Direction::BOTH.map(|d| deviation(name, canonical, position, d, 0.0))
    }
}
