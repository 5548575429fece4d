//! The effects of turning. One file and one line each; effects of several joints share a file.

mod bed_sag;
mod bed_twist;
mod carriage_compliance;
mod chuck_tilt;
mod cross_slide_play;
mod force_feedback;
mod front_guideway_wear;
mod guideway_height;
mod guideway_taper;
mod guideway_wear;
mod insert_change;
mod joint_contact;
mod joint_friction;
mod offset_correction;
mod rest_offset;
mod setting_error;
mod spindle_thermal_drift;
mod support_compliance;
mod tailstock_offset;
mod tool_breakdown;
mod tool_thermal_growth;
mod tool_wear;
mod wear_land;
mod workpiece_heating;

pub use force_feedback::contradiction;

use super::machine::Machine;
use super::setup::Setup;
use crate::process::{CatalogueEffect, Odds};

/// The registry.
pub const ALL: &[&dyn CatalogueEffect<Setup, Machine>] = &[
    &support_compliance::HEADSTOCK,
    &support_compliance::TAILSTOCK,
    &carriage_compliance::CARRIAGE_COMPLIANCE,
    &joint_contact::HEADSTOCK,
    &joint_contact::TAILSTOCK,
    &joint_contact::CARRIAGE,
    &joint_friction::HEADSTOCK,
    &joint_friction::TAILSTOCK,
    &chuck_tilt::CHUCK_TILT,
    &force_feedback::FORCE_FEEDBACK,
    &tool_wear::TOOL_WEAR,
    &tool_breakdown::TOOL_BREAKDOWN,
    &wear_land::WEAR_LAND,
    &tool_thermal_growth::TOOL_THERMAL_GROWTH,
    &workpiece_heating::WORKPIECE_HEATING,
    &spindle_thermal_drift::SPINDLE_THERMAL_DRIFT,
    &guideway_taper::GUIDEWAY_TAPER,
    &bed_twist::BED_TWIST,
    &guideway_height::GUIDEWAY_HEIGHT,
    &guideway_wear::GUIDEWAY_WEAR,
    &front_guideway_wear::FRONT_GUIDEWAY_WEAR,
    &bed_sag::BED_SAG,
    &tailstock_offset::TAILSTOCK_OFFSET,
    &rest_offset::REST_OFFSET,
    &setting_error::SETTING_ERROR,
    &cross_slide_play::CROSS_SLIDE_PLAY,
    &offset_correction::OFFSET_CORRECTION,
    &insert_change::INSERT_CHANGE,
];

/// Effects of units whose compliance a model has in a structure or a file.
const DRAWN: [&str; 5] =
    ["headstock-compliance", "headstock-contact", "tailstock-compliance", "tailstock-contact", "chuck-tilt"];

/// Odds of effects that are not those of the catalogue: where that is known little else is left to give way.
pub fn odds(setup: &Setup, effect: &str) -> Option<Odds> {
    let is_known = (setup.base.is_some() || setup.imported.is_some()) && DRAWN.contains(&effect);
    is_known.then_some(Odds::of(0.1, "what gives way there stands in the model, whose values are on trial"))
}

#[cfg(test)]
pub(super) mod bench {
    //! A lathe to try effects on.

    pub use super::super::forward::unloaded;
    use super::super::machine::Moment;
    use super::super::{Turning, condense, deflections};
    use crate::process::{Assembled, with_effect};

    /// Ø50 × 600 mm between centres, 500 N, 0.2 mm/rev at 600 rpm (a pass of 5 min), three parts every 10
    /// min.
    const MODEL: &str = r#"
        workpiece = { material = "steel", segments = [{ length = "600 mm", diameter = "50 mm" }] }
        workholding = { type = "WORKHOLDING" }
        cut = { depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "600 rpm", radial_force = "500 N" }
        batch = { parts = 3, cycle_time = "10 min", pauses = [{ after = 2, duration = "20 min" }] }
    "#;

    /// The lathe with one effect of these canonical values.
    pub fn lathe(workholding: &str, name: &str, canonical: &[f64]) -> Assembled<Turning> {
        with_effect(&model(workholding), name, canonical)
    }

    /// The text of the lathe.
    pub fn model(workholding: &str) -> String {
        MODEL.replace("WORKHOLDING", workholding)
    }

    /// Change of diameter by the effect, um, whatever the force.
    pub fn shift(name: &str, canonical: &[f64], moment: Moment) -> f64 {
        1e6 * unloaded(lathe("centres", name, canonical).machine(), &moment).unwrap()
    }

    /// The same of a slender shaft that is held in some way, at x (m), on part 2.
    pub fn shift_in(workholding: &str, name: &str, canonical: &[f64], x: f64) -> f64 {
        let text = model(workholding) + "mesh = { beam = \"euler-bernoulli\" }\n";
        let lathe = with_effect::<Turning>(&text, name, canonical);
        1e6 * unloaded(lathe.machine(), &Moment { x, ..moment() }).unwrap()
    }

    /// Gap between tool and work at x (m) under the nominal force, in um.
    pub fn gap(lathe: &Assembled<Turning>, x: f64) -> f64 {
        let shaft = condense(lathe.machine(), &[x]).unwrap();
        1e6 * deflections(lathe.machine(), &shaft, &[x], &Default::default()).unwrap()[0].total
    }

    /// On part 2 at x = 0.15 m: 3.75 min into the cut.
    pub fn moment() -> Moment {
        Moment { x: 0.15, diameter: 0.05, part: 2, time: 825.0, path: 800.0 }
    }
}
