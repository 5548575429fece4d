//! A joint across the body holds heat back.
//!
//! Two parts that are pressed together touch at few points: the heat that crosses the section at `at` is h·A·[T], h the conductance (W/(m² K)) and [T] the
//! step of the temperature. Dry ground steel faces have some 1000 to 10 000 W/(m² K), rough or loose ones less. The same everywhere in the
//! section and at all times. At a step of the diameter the smaller section touches. A place exactly on the joint belongs to the side of the base.

use super::super::{Contact, Machine};
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::{CONVECTION, LENGTH};

/// `contact-resistance`.
pub struct ContactResistance;

static DESCRIPTION: Description = Description {
    name: "contact-resistance",
    about: "a joint across the section resists the flow of heat",
    law: "k*A*dT/dx = conductance*A*[T] across the section at x = at",
    source: "thermal contact conductance",
    parameters: &[
        Parameter::place("at", LENGTH, "from the base", "x", (1.0, 1000.0)),
        Parameter::conductance("conductance", CONVECTION, "of the joint", (100.0, 50_000.0)),
    ],
    look_alikes: &[("convection", "temperatures on both sides of the joint")],
};

impl Effect<Machine> for ContactResistance {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        let conductance = values["conductance"];
        // An infinite conductance is no joint.
        if conductance.is_finite() {
            machine.contacts.push(Contact { at: values["at"], conductance });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    /// The step is what crosses the joint over h·A.
    #[test]
    fn the_temperature_steps_at_the_joint() {
        let heated = rod(&[("contact-resistance", &[100.0, 20_000.0])]);
        let at = |x: f64| rise(&heated, x, 3000.0);
        let flow = conductance() * (at(0.1) - at(0.0999)) / 1e-4;
        let step = flow / (20_000.0 * std::f64::consts::PI * 1e-4);
        // What the 0.1 mm on either side hold.
        assert!(((at(0.1001) - at(0.1)) / step - 1.0).abs() < 0.1, "{} and {step}", at(0.1001) - at(0.1));
        assert!(step > 0.5);
    }
}
