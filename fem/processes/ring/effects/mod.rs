//! The effects of a chucked ring. One file and one line each.

mod centrifugal_unloading;
mod chuck_runout;
mod copying;
mod cutting_heat;
mod jaw_contact_arc;
mod jaw_imbalance;
mod jaw_position;
mod residual_stress;
mod spindle_error;

use super::machine::Machine;
use super::setup::Setup;
use crate::process::CatalogueEffect;

/// The registry.
pub const ALL: &[&dyn CatalogueEffect<Setup, Machine>] = &[
    &jaw_contact_arc::JAW_CONTACT_ARC,
    &jaw_position::JAW_POSITION,
    &jaw_imbalance::JAW_IMBALANCE,
    &centrifugal_unloading::CENTRIFUGAL_UNLOADING,
    &residual_stress::RESIDUAL_STRESS,
    &spindle_error::SPINDLE_ERROR,
    &chuck_runout::CHUCK_RUNOUT,
    &cutting_heat::CUTTING_HEAT,
    &copying::COPYING,
];

#[cfg(test)]
mod bench {
    //! A chuck to try effects on.

    use super::super::Ring;
    use super::super::machine::BorePoint;
    use crate::process::{Assembled, with_effect};

    /// Ø100/84 × 20 mm of steel in three jaws of 3 kN, bored at 400 rpm; deviations from the set circle.
    const MODEL: &str = r#"
        workpiece = { material = "steel", outer_diameter = "100 mm", inner_diameter = "84 mm", width = "20 mm" }
        chuck = { jaws = 3, jaw_force = "3 kN" }
        cut = { spindle_speed = "400 rpm", force_per_depth = "1 kN/mm" }
        mesh = { circumferential = 72, radial = 2 }
        measurement = { reference = "absolute" }
    "#;

    /// The chuck with one effect of these canonical values.
    pub fn chuck(name: &str, canonical: &[f64]) -> Assembled<Ring> {
        with_effect(MODEL, name, canonical)
    }

    /// The same in so many jaws.
    pub fn chuck_of(jaws: usize, name: &str, canonical: &[f64]) -> Assembled<Ring> {
        with_effect(&MODEL.replace("jaws = 3", &format!("jaws = {jaws}")), name, canonical)
    }

    /// Mark of an effect on a bore that no jaw squeezes, um, at an angle with the ring's mark at an orientation (deg)
    /// and a blank that is off by 50 um.
    pub fn mark(name: &str, canonical: &[f64], angle: f64, orientation: f64) -> f64 {
        let (angle, orientation) = (angle.to_radians(), orientation.to_radians());
        1e6 * chuck(name, canonical).machine().deviation(&BorePoint { angle, orientation, blank: 5e-5 }, 0.0).unwrap()
    }
}
