//! The effects of turning. One file and one line each.

mod carriage_compliance;
mod carriage_contact;
mod chuck_tilt;
mod force_feedback;
mod guideway_height;
mod guideway_taper;
mod guideway_wear;
mod headstock_compliance;
mod headstock_contact;
mod setting_error;
mod spindle_thermal_drift;
mod tailstock_compliance;
mod tailstock_contact;
mod tailstock_offset;
mod tool_thermal_growth;
mod tool_wear;
mod workpiece_heating;

use super::Machine;
use crate::process::Effect;

/// The registry.
pub const ALL: &[&dyn Effect<Machine>] = &[
    &headstock_compliance::HeadstockCompliance,
    &tailstock_compliance::TailstockCompliance,
    &carriage_compliance::CarriageCompliance,
    &headstock_contact::HeadstockContact,
    &tailstock_contact::TailstockContact,
    &carriage_contact::CarriageContact,
    &chuck_tilt::ChuckTilt,
    &force_feedback::ForceFeedback,
    &tool_wear::ToolWear,
    &tool_thermal_growth::ToolThermalGrowth,
    &workpiece_heating::WorkpieceHeating,
    &spindle_thermal_drift::SpindleThermalDrift,
    &guideway_taper::GuidewayTaper,
    &guideway_height::GuidewayHeight,
    &guideway_wear::GuidewayWear,
    &tailstock_offset::TailstockOffset,
    &setting_error::SettingError,
];

#[cfg(test)]
mod bench {
    //! A lathe to try effects on.

    use std::sync::Arc;

    use super::super::{Lathe, Setup};
    use crate::input::Reader;
    use crate::process::Active;
    use crate::process::turning::{Machine, Moment, effect};

    /// Ø50 × 600 mm between centres, 500 N, 0.2 mm/rev at 600 rpm (a pass of 5 min), three parts every 10 min.
    const MODEL: &str = r#"
        workpiece = { material = "steel", segments = [{ length = "600 mm", diameter = "50 mm" }] }
        workholding = { type = "WORKHOLDING" }
        cut = { depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "600 rpm", radial_force = "500 N" }
        batch = { parts = 3, cycle_time = "10 min", pauses = [{ after = 2, duration = "20 min" }] }
    "#;

    /// The lathe with one effect of these canonical values.
    pub fn lathe(workholding: &str, name: &str, canonical: &[f64]) -> Lathe {
        let model = toml_edit::Document::parse(MODEL.replace("WORKHOLDING", workholding)).unwrap();
        let (setup, _, problems) = Reader::document(model.as_table(), Setup::read);
        assert_eq!(problems, []);
        let description = effect(name).unwrap().description();
        let values = description.parameters.iter().zip(canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
        Lathe::equip(Arc::new(setup), &[Active { description, values, written: None }])
    }

    /// What the effect adds to the diameter, in um, whatever the force.
    pub fn shift(name: &str, canonical: &[f64], moment: Moment) -> f64 {
        let machine: &Machine = &lathe("centres", name, canonical).machine;
        1e6 * machine.shifts.iter().map(|s| s(&moment)).sum::<f64>()
    }

    /// Gap between tool and work at x (m) under the nominal force, in um.
    pub fn gap(lathe: &Lathe, x: f64) -> f64 {
        let shaft = lathe.condense(&[x]).unwrap();
        1e6 * lathe.deflections(&shaft, &[x], &Default::default()).unwrap()[0].total
    }

    /// On part 2 at x = 0.15 m: 3.75 min into the cut.
    pub fn moment() -> Moment {
        Moment { x: 0.15, diameter: 0.05, time: 825.0, path: 800.0 }
    }
}
