//! The drives of x and y: what each has of its own, and where positions are measured.

use super::path::AXES;
use crate::element::Round;
use crate::input::Reader;
use crate::material::Material;
use crate::process::Nut;
use crate::solve::Bar;
use crate::units::LENGTH;

/// The place at which the position of an axis is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Feedback {
    /// On the motor: what lies between it and the slide is not seen.
    Motor,
    /// On the slide: screw and nut are inside the loop.
    Scale,
}

/// A drive.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drive {
    /// Travel in a turn of the screw or in a period of the scale, m.
    pub lead: Option<f64>,
    /// The screw on its fixed bearing, positions counted from the contour's centre.
    pub screw: Option<Bar>,
    /// The nut on it, where that is preloaded.
    pub nut: Option<Nut>,
}

impl Feedback {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] = &[("motor", Self::Motor), ("scale", Self::Scale)];

    /// Why an effect between motor and slide does not show, if so.
    pub fn sees_screw(self) -> Result<(), String> {
        match self {
            Self::Motor => Ok(()),
            Self::Scale => {
                Err("lies inside the loop, and the scale takes it out: feedback = \"scale\" in [drives]".into())
            }
        }
    }
}

/// Reads what each axis has of its own; `lead` is that of both where they do not say (m).
pub fn read(t: &Reader, lead: Option<f64>) -> [Drive; 2] {
    AXES.map(|axis| {
        let own = t.optional_table(axis, "what this axis has of its own", |t| {
            let own = t.quantity("lead", LENGTH, "travel in a turn of its screw or a period of its scale").positive();
            let own = own.optional();
            let screw = t.optional_table("screw", "its screw, which elastic-lost-motion needs", |t| {
                let material = Material::read(t, "material");
                let diameter = t.quantity("diameter", LENGTH, "its diameter").positive().required();
                let about = "place of its fixed bearing along the axis, from the contour's centre";
                let held = vec![t.quantity("fixed_at", LENGTH, about).required()];
                let area = Round { diameter, bore: 0.0 }.area();
                (Bar { axial_rigidity: material.youngs_modulus * area, held }, Nut::read(t))
            });
            let (screw, nut) = screw.unzip();
            Drive { lead: own.or(lead), screw, nut: nut.flatten() }
        });
        own.unwrap_or(Drive { lead, ..Drive::default() })
    })
}
