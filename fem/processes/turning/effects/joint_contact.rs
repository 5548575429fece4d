//! The joints of supports and carriage close by the contact law.
//!
//! Rough surfaces in contact approach by y = c·Qⁿ under the reaction Q, n < 1: much at first, little later
//! [seed 002 (29)]. In series with the spring of the joint. c in m/Nⁿ, n in (0, 1]. The joint presses only:
//! for Q ≤ 0 it does not move, and a reaction that would have to pull is reported. Friction beside it: `headstock-friction`.

use super::super::machine::{Effect, Machine};
use super::super::setup::Setup;
use super::support_compliance::a_tailstock;
use crate::input::Bounds;
use crate::process::{Belongs, Odds, Parameter, UnitRole, nothing};
use crate::units::{CONTACT_COEFFICIENT, NUMBER};

/// `headstock-contact`.
pub static HEADSTOCK: Effect<2> = contact(
    "headstock",
    ["headstock-contact", "the joint at the headstock closes under its reaction, much at first and little later"],
    "y = c*Q^n at x = 0, n < 1",
    &[("headstock-compliance", "a third force level: a spring yields in proportion")],
    nothing,
    |[c, n], machine| machine.headstock.add_contact(c, n),
);

/// `tailstock-contact`.
pub static TAILSTOCK: Effect<2> = contact(
    "tailstock",
    ["tailstock-contact", "the joint at the tailstock closes under its reaction, much at first and little later"],
    "y = c*Q^n at x = L, n < 1",
    &[("tailstock-compliance", "a third force level: a spring yields in proportion")],
    a_tailstock,
    |[c, n], machine| machine.tailstock.add_contact(c, n),
);

/// `carriage-contact`: tool, slide and carriage bear the whole force P, y += c·Pⁿ.
pub static CARRIAGE: Effect<2> = contact(
    "carriage",
    [
        "carriage-contact",
        "the joints of tool, slide and carriage close under the force, much at first and little later",
    ],
    "y += c*P^n, n < 1",
    &[
        ("carriage-compliance", "a third force level: a spring yields in proportion"),
        ("setting-error", "a second force"),
    ],
    nothing,
    |[c, n], machine| machine.carriage.add_contact(c, n),
);

const fn contact(
    unit: &'static str,
    [name, about]: [&'static str; 2],
    law: &'static str,
    look_alikes: &'static [(&'static str, &'static str)],
    needs: fn(&Setup) -> Result<(), String>,
    act: fn([f64; 2], &mut Machine),
) -> Effect<2> {
    Effect {
        name,
        about,
        law,
        source: "seed 002 (29)",
        belongs: Belongs::Unit(unit, UnitRole::Contact),
        odds: Odds::of(0.15, "every joint is one, but of a preloaded one a spring says as much"),
        parameters: [
            Parameter::amplitude("c", CONTACT_COEFFICIENT, "coefficient of the contact", (0.01, 5.0)),
            Parameter::shape("n", NUMBER, "exponent of the force", (0.3, 0.8)).within(Bounds::Within(0.0, 1.0)),
        ],
        look_alikes,
        needs,
        act,
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn each_joint_closes_under_what_it_bears() {
        // Of 500 N at x = L/4 the headstock bears 3/4, the tailstock 1/4, the carriage all.
        for (name, lever) in [("headstock-contact", 0.75f64), ("tailstock-contact", 0.25), ("carriage-contact", 1.0)] {
            let [ideal, closing] = [0.0, 0.2].map(|c| gap(&lathe("centres", name, &[c, 0.5]), 0.15));
            assert!((closing - ideal - lever * 0.2 * (500.0 * lever).sqrt()).abs() < 1e-9, "{name}");
        }
    }
}
