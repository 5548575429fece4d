//! The joint between work and headstock closes by the contact law.
//!
//! Rough surfaces in contact approach by y = c·Qⁿ under the reaction Q, n < 1: much at first, little later [seed 002 (29)]. In series with
//! the headstock's spring. c in m/Nⁿ, n in (0, 1]. The joint presses only: for Q ≤ 0 it does not move, and
//! a reaction that would have to pull is reported. Left out: hysteresis.

use super::super::Machine;
use crate::input::Bounds;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::{CONTACT_COEFFICIENT, NUMBER};

/// `headstock-contact`.
pub struct HeadstockContact;

static DESCRIPTION: Description = Description {
    name: "headstock-contact",
    about: "the joint at the headstock closes under its reaction, much at first and little later",
    law: "y = c*Q^n at x = 0, n < 1",
    source: "seed 002 (29)",
    parameters: &[
        Parameter::amplitude("c", CONTACT_COEFFICIENT, "coefficient of the contact", (0.01, 5.0)),
        Parameter::shape("n", NUMBER, "exponent of the force", (0.3, 0.8)).within(Bounds::Within(0.0, 1.0)),
    ],
    look_alikes: &[("headstock-compliance", "a third force level: a spring yields in proportion")],
};

impl Effect<Machine> for HeadstockContact {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        machine.headstock.add_contact(values["c"], values["n"]);
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn between_centres_the_reaction_is_the_levers() {
        let ideal = lathe("centres", "headstock-contact", &[0.0, 0.5]);
        let closing = lathe("centres", "headstock-contact", &[0.2, 0.5]);
        let lever: f64 = 0.75;
        let expected = lever * 0.2 * (500.0 * lever).sqrt();
        assert!((gap(&closing, 0.15) - gap(&ideal, 0.15) - expected).abs() < 1e-9);
    }
}
