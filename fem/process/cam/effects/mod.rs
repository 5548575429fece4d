//! The effects of a cam grinder. One file and one line each.

mod centre_height;
mod grinding_deflection;
mod infeed_backlash;
mod servo_lag;
mod wheel_wear;

use super::Machine;
use crate::process::Effect;

/// The registry.
pub const ALL: &[&dyn Effect<Machine>] = &[
    &wheel_wear::WheelWear,
    &servo_lag::ServoLag,
    &infeed_backlash::InfeedBacklash,
    &centre_height::CentreHeight,
    &grinding_deflection::GrindingDeflection,
];

#[cfg(test)]
mod bench {
    //! A grinder to try effects on.

    use std::sync::Arc;

    use super::super::{Cam, Setup, effect};
    use crate::input::Reader;
    use crate::process::Active;

    /// A circle of 20 mm radius, 4 mm beside the cam's axis, and a wheel of 175 mm; 3600 blocks err by 2 nm at most.
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
        let model = toml_edit::Document::parse(MODEL).unwrap();
        let (setup, _, problems) = Reader::document(model.as_table(), Setup::read);
        assert_eq!(problems, []);
        let description = effect(name).unwrap().description();
        let values = description.parameters.iter().zip(canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
        let cam = Cam::equip(Arc::new(setup.unwrap()), &[Active { description, values, written: None }]);
        let pass = cam.machine.usual();
        let motion = cam.machine.motion(pass);
        let at = |angle: &f64| cam.deviation(&motion, cam.setup().profile.at_angle(angle.to_radians()), pass);
        degrees.iter().map(|angle| 1e6 * at(angle).unwrap()).collect()
    }
}
