//! A joint across the body holds heat back.
//!
//! Two parts that are pressed together touch at few points: the heat that crosses the section at `at` is
//! h·A·[T], h the conductance (W/(m² K)) and [T] the step of the temperature. Dry ground steel faces have
//! some 1000 to 10 000 W/(m² K), rough or loose ones less. It is the same everywhere in the section and at
//! all times. At a step of the diameter the smaller section touches. A place exactly on the joint belongs to
//! the side of the base.

use super::super::machine::{Contact, Effect};
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::{CONVECTION, LENGTH};

/// `contact-resistance`.
pub static CONTACT_RESISTANCE: Effect<2> = Effect {
    name: "contact-resistance",
    about: "a joint across the section resists the flow of heat",
    law: "k*A*dT/dx = conductance*A*[T] across the section at x = at",
    source: "thermal contact conductance",
    belongs: Belongs::Test,
    odds: Odds::of(0.15, "only a body of several pieces has a joint"),
    parameters: [
        Parameter::place("at", LENGTH, "from the base", "x", (1.0, 1000.0)),
        Parameter::conductance("conductance", CONVECTION, "of the joint", (100.0, 50_000.0)),
    ],
    look_alikes: &[
        ("convection", "temperatures on both sides of the joint"),
        ("heater-capacity", "temperatures close to the heater"),
        ("sensor-lag", "the elongation, which no sensor delays"),
    ],
    needs: a_rod,
    act: |[at, conductance], machine| {
        // An infinite conductance is no joint.
        if conductance.is_finite() {
            machine.contacts.push(Contact { at, conductance });
        }
    },
};

fn a_rod(setup: &Setup) -> Result<(), String> {
    match setup.body.plane() {
        None => Ok(()),
        Some(_) => Err(format!("is known of rods, which it cuts through, not of {}", setup.body.kind())),
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    /// The step is what crosses the joint over h·A.
    #[test]
    fn the_temperature_steps_at_the_joint() {
        let heated = rod("contact-resistance = { at = '100 mm', conductance = '20000 W/m^2/K' }");
        let at = |x: f64| rise(&heated, x, 3000.0);
        let flow = conductance() * (at(0.1) - at(0.0999)) / 1e-4;
        let step = flow / (20_000.0 * std::f64::consts::PI * 1e-4);
        // The 0.1 mm on either side resist too.
        assert!(((at(0.1001) - at(0.1)) / step - 1.0).abs() < 0.1, "{} and {step}", at(0.1001) - at(0.1));
        assert!(step > 0.5);
    }

    /// A search brings joints and sources as close to each other as it likes.
    #[test]
    fn a_source_on_the_joint_is_on_its_side() {
        let at = |apart: f64| {
            let joint = "contact-resistance = { at = '70 mm', conductance = '3000 W/m^2/K' }";
            rod(&format!("{joint}\nextra-source = {{ at = '{} mm', power = '4 W' }}", 70.0 + apart))
        };
        let on = rise(&at(0.0), 0.12, 3600.0);
        for apart in [1e-10, 1e-8, 1e-6, 1e-5, 1e-4, 2e-4] {
            let near = rise(&at(-apart), 0.12, 3600.0);
            assert!((near / on - 1.0).abs() < 1e-4, "{apart} mm: {near} {on}");
        }
    }
}
