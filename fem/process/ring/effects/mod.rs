//! The effects of a chucked ring. One file and one line each.

mod centrifugal_unloading;
mod copying;
mod cutting_heat;
mod jaw_contact_arc;
mod jaw_position;
mod residual_stress;
mod spindle_error;

use super::Machine;
use crate::process::Effect;

/// The registry.
pub const ALL: &[&dyn Effect<Machine>] = &[
    &jaw_contact_arc::JawContactArc,
    &jaw_position::JawPosition,
    &centrifugal_unloading::CentrifugalUnloading,
    &residual_stress::ResidualStress,
    &spindle_error::SpindleError,
    &cutting_heat::CuttingHeat,
    &copying::Copying,
];

#[cfg(test)]
mod bench {
    //! A chuck to try effects on.

    use std::sync::Arc;

    use super::super::{Chucked, Place, Setup, effect};
    use crate::input::Reader;
    use crate::process::Active;

    /// Ø100/84 × 20 mm of steel in three jaws of 3 kN, bored at 400 rpm; deviations from the set circle.
    const MODEL: &str = r#"
        workpiece = { material = "steel", outer_diameter = "100 mm", inner_diameter = "84 mm", width = "20 mm" }
        chuck = { jaws = 3, jaw_force = "3 kN" }
        cut = { spindle_speed = "400 rpm", force_per_depth = "1 kN/mm" }
        mesh = { circumferential = 72, radial = 2 }
        measurement = { reference = "absolute" }
    "#;

    /// The chuck with one effect of these canonical values.
    pub fn chuck(name: &str, canonical: &[f64]) -> Chucked {
        chuck_with(&[(name, canonical)])
    }

    /// The chuck with some effects of these canonical values.
    pub fn chuck_with(effects: &[(&str, &[f64])]) -> Chucked {
        let model = toml_edit::Document::parse(MODEL).unwrap();
        let (setup, _, problems) = Reader::document(model.as_table(), Setup::read);
        assert_eq!(problems, []);
        let active = |(name, canonical): &(&str, &[f64])| {
            let description = effect(name).unwrap().description();
            let values = description.parameters.iter().zip(*canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
            Active { description, values, written: None }
        };
        Chucked::equip(Arc::new(setup), &effects.iter().map(active).collect::<Vec<_>>())
    }

    /// What the effect marks on the bore, in um, at an angle with the ring's mark at an orientation (deg) and a blank that is off by 50 um.
    pub fn mark(name: &str, canonical: &[f64], angle: f64, orientation: f64) -> f64 {
        let (angle, orientation) = (angle.to_radians(), orientation.to_radians());
        1e6 * chuck(name, canonical).marks_at(&Place { angle, orientation, blank: 5e-5 })
    }
}
