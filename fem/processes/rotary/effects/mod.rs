//! The effects of a rotary axis. One file and one line each.

mod backlash;
mod compliance;
mod elastic_wind_up;
mod gear_eccentricity;
mod interpolation_error;
mod motor_gear_eccentricity;
mod needs;
mod ratio_error;
mod reference_shift;
mod scale_eccentricity;
mod scale_second_harmonic;
mod thermal_drift;
mod tooth_error;
mod unbalance;
mod uneven_backlash;
mod wheel_eccentricity;
mod worm_error;
mod worm_second_harmonic;

use super::machine::Machine;
use super::setup::Setup;
use crate::process::CatalogueEffect;

/// The registry.
pub const ALL: &[&dyn CatalogueEffect<Setup, Machine>] = &[
    &worm_error::WORM_ERROR,
    &worm_second_harmonic::WORM_SECOND_HARMONIC,
    &wheel_eccentricity::WHEEL_ECCENTRICITY,
    &tooth_error::TOOTH_ERROR,
    &gear_eccentricity::GEAR_ECCENTRICITY,
    &motor_gear_eccentricity::MOTOR_GEAR_ECCENTRICITY,
    &ratio_error::RATIO_ERROR,
    &backlash::BACKLASH,
    &uneven_backlash::UNEVEN_BACKLASH,
    &elastic_wind_up::ELASTIC_WIND_UP,
    &compliance::COMPLIANCE,
    &unbalance::UNBALANCE,
    &scale_eccentricity::SCALE_ECCENTRICITY,
    &scale_second_harmonic::SCALE_SECOND_HARMONIC,
    &interpolation_error::INTERPOLATION_ERROR,
    &thermal_drift::THERMAL_DRIFT,
    &reference_shift::REFERENCE_SHIFT,
];

#[cfg(test)]
mod bench {
    //! Axes to try effects on.

    use super::super::{Rotary, rows};
    use crate::positioning::Direction;
    use crate::process::{ForwardModel, with_effect};
    use crate::units::{ANGLE, SMALL_ANGLE};

    /// A worm of 1:180 with a rigid wheel of 100 mm that lies, and a scale of 50 mm and 3600 lines on the table.
    pub const WORM: &str = r#"
        axis = { range = "360 deg", orientation = "horizontal" }
        drive = { type = "worm", teeth = 180, pitch_radius = "100 mm" }
        scale = { at = "table", radius = "50 mm", lines = 3600 }
    "#;
    /// The same with a drive that yields by an arc second under 2 N·m.
    pub const SPRUNG: &str = r#"
        axis = { range = "360 deg", orientation = "horizontal" }
        drive = { type = "worm", teeth = 180, pitch_radius = "100 mm", stiffness = "2 N*m/arcsec" }
    "#;
    /// 18:72 and 20:100, a joint that turns by 180 degrees.
    pub const TRAIN: &str = r#"
        axis = { range = "180 deg" }
        drive = { type = "gears", stages = [{ driving = 18, driven = 72 }, { driving = 20, driven = 100 }] }
    "#;

    /// Deviation (arcsec) of a machine with one effect of these canonical values, at an angle (deg) from a side, after
    /// minutes, under a torque (N·m).
    pub fn deviation(
        (model, name, canonical): (&str, &str, &[f64]),
        angle: f64,
        direction: Direction,
        minutes: f64,
        torque: f64,
    ) -> f64 {
        let rows = rows::rows([(ANGLE.to_si(angle), direction, 1.0, 60.0 * minutes)], torque);
        SMALL_ANGLE.from_si(with_effect::<Rotary>(model, name, canonical).observe(&rows).unwrap()[0])
    }

    /// The same forwards and backwards, cold and free.
    pub fn both(effect: (&str, &str, &[f64]), angle: f64) -> [f64; 2] {
        turned(effect, angle, 0.0)
    }

    /// The same forwards and backwards, cold, under a torque (N·m).
    pub fn turned(effect: (&str, &str, &[f64]), angle: f64, torque: f64) -> [f64; 2] {
        Direction::BOTH.map(|direction| deviation(effect, angle, direction, 0.0, torque))
    }

    /// Whether two values (arcsec) are one but for round-off.
    pub fn near(found: f64, expected: f64) -> bool {
        (found - expected).abs() < 1e-8 * expected.abs().max(1.0)
    }
}
