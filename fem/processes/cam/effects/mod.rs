//! The effects of a cam grinder. One file and one line each.

mod centre_height;
mod grinding_deflection;
mod infeed_backlash;
mod servo_lag;
mod wheel_wear;

use super::machine::Machine;
use super::setup::Setup;
use crate::process::CatalogueEffect;

/// The registry.
pub const ALL: &[&dyn CatalogueEffect<Setup, Machine>] = &[
    &wheel_wear::WHEEL_WEAR,
    &servo_lag::SERVO_LAG,
    &infeed_backlash::INFEED_BACKLASH,
    &centre_height::CENTRE_HEIGHT,
    &grinding_deflection::GRINDING_DEFLECTION,
];

#[cfg(test)]
mod bench {
    //! A grinder to try effects on.

    use super::super::CamGrinding;
    use super::super::rows;
    use crate::process::{ForwardModel, with_effect};

    /// A circle of 20 mm radius, 4 mm beside the cam's axis, and a wheel of 175 mm; 3600 blocks err by 2 nm
    /// at most.
    const MODEL: &str = r#"
        wheel = { radius = "175 mm" }
        cut = { stock = "20 um", force_per_rate = "10 N/(mm^2/s)" }
        program = { blocks = 3600, cam_speed = "20 rpm" }
        [profile]
        start = ["24 mm", "0 mm"]
        segments = [{ arc = { centre = ["4 mm", "0 mm"], sweep = "360 deg" } }]
    "#;

    /// Deviation in um at polar angles (deg), with one effect of these canonical values.
    pub fn deviations(name: &str, canonical: &[f64], degrees: &[f64]) -> Vec<f64> {
        let cam = with_effect::<CamGrinding>(MODEL, name, canonical);
        let angles = degrees.iter().map(|angle| angle.to_radians()).collect();
        let deviations = cam.observe(&rows::around(angles, cam.setup().program.usual())).unwrap();
        deviations.iter().map(|d| 1e6 * d).collect()
    }
}
