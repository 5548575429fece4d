//! The effects of a feed axis. One file and one line each.

mod abbe_error;
mod backlash;
mod elastic_lost_motion;
mod periodic_error;
mod reference_shift;
mod scale_error;
mod thermal_growth;
mod uneven_backlash;
mod worn_screw;

use super::machine::Machine;
use super::setup::Setup;
use crate::process::CatalogueEffect;

/// The registry.
pub const ALL: &[&dyn CatalogueEffect<Setup, Machine>] = &[
    &scale_error::SCALE_ERROR,
    &periodic_error::PERIODIC_ERROR,
    &backlash::BACKLASH,
    &uneven_backlash::UNEVEN_BACKLASH,
    &worn_screw::WORN_SCREW,
    &elastic_lost_motion::ELASTIC_LOST_MOTION,
    &thermal_growth::THERMAL_GROWTH,
    &abbe_error::ABBE_ERROR,
    &reference_shift::REFERENCE_SHIFT,
];

#[cfg(test)]
mod bench {
    //! An axis to try effects on.

    use super::super::{Axis, rows};
    use crate::positioning::Direction;
    use crate::process::{ForwardModel, with_effect};

    /// 500 mm of travel on a steel screw of 32 mm and 10 mm a turn, held at 100 mm.
    const MODEL: &str = r#"
        axis = { travel = "500 mm" }
        screw = { material = "steel", diameter = "32 mm", lead = "10 mm", fixed_at = "100 mm" }
    "#;

    /// Deviation (um) with one effect of these canonical values, at a position (mm) forwards or backwards,
    /// after minutes.
    pub fn deviation(name: &str, canonical: &[f64], position: f64, direction: Direction, minutes: f64) -> f64 {
        let rows = rows::rows([(1e-3 * position, direction, 1.0, 60.0 * minutes)]);
        1e6 * with_effect::<Axis>(MODEL, name, canonical).observe(&rows).unwrap()[0]
    }

    /// The same forwards and backwards, cold, while a force (N) pulls towards -.
    pub fn pulled(name: &str, canonical: &[f64], position: f64, pull: f64) -> [f64; 2] {
        let mut rows = rows::rows(Direction::BOTH.map(|d| (1e-3 * position, d, 1.0, 0.0)));
        rows.columns[rows::PULL].fill(pull);
        let readings = with_effect::<Axis>(MODEL, name, canonical).observe(&rows).unwrap();
        [1e6 * readings[0], 1e6 * readings[1]]
    }

    /// The same forwards and backwards, cold.
    pub fn both(name: &str, canonical: &[f64], position: f64) -> [f64; 2] {
        Direction::BOTH.map(|d| deviation(name, canonical, position, d, 0.0))
    }
}
