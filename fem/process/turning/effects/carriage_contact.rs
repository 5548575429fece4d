//! The joints of tool, slide and carriage close by the contact law.
//!
//! y += c·Pⁿ, n < 1 [seed 002 (29)], in series with the carriage's spring. c in m/Nⁿ, n in (0, 1].

use super::super::Machine;
use crate::input::Bounds;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::{CONTACT_COEFFICIENT, NUMBER};

/// `carriage-contact`.
pub struct CarriageContact;

static DESCRIPTION: Description = Description {
    name: "carriage-contact",
    about: "the joints of tool, slide and carriage close under the force, much at first and little later",
    law: "y += c*P^n, n < 1",
    source: "seed 002 (29)",
    parameters: &[
        Parameter::amplitude("c", CONTACT_COEFFICIENT, "coefficient of the contact", (0.01, 5.0)),
        Parameter::shape("n", NUMBER, "exponent of the force", (0.3, 0.8)).within(Bounds::Within(0.0, 1.0)),
    ],
    look_alikes: &[
        ("carriage-compliance", "a third force level: a spring yields in proportion"),
        ("setting-error", "a second force"),
    ],
};

impl Effect<Machine> for CarriageContact {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        machine.carriage.add_contact(values["c"], values["n"]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn it_adds_the_contact_law_everywhere() {
        let ideal = lathe("centres", "carriage-contact", &[0.0, 0.5]);
        let closing = lathe("centres", "carriage-contact", &[0.2, 0.5]);
        assert!((gap(&closing, 0.4) - gap(&ideal, 0.4) - 0.2 * 500f64.sqrt()).abs() < 1e-9);
    }
}
