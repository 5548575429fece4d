//! Friction beside the joints of headstock and tailstock.
//!
//! A quill in its barrel, a foot on its bed slide before they yield: the joint bears S of its reaction Q = S + T, |T| ≤ f, and
//! y = u(S) by spring and contact. Where the tool comes near a support its reaction rises and S = Q − f; where it goes away
//! the joint stays as it is until the reaction has fallen by 2f, and follows with S = Q + f [Coulomb's law; the play operator].
//! A support thus shows the side from which the tool came, and what the next pass finds is what the last left: S between −f
//! and f. f in N, alike in every pass. Where nothing yields nothing rubs. Left out: a friction that grows with the load,
//! vibration that shakes a joint loose, friction of the carriage, which bears the same force all along.

use super::super::machine::{Effect, Machine, Support};
use super::support_compliance::a_tailstock;
use crate::process::{Belongs, Odds, Parameter, UnitRole};
use crate::units::FORCE;

/// `headstock-friction`.
pub static HEADSTOCK: Effect<1> = friction(
    "headstock",
    ["headstock-friction", "friction holds the joint at the headstock, which stays behind the force"],
    "at x = 0: S = Q - f where Q rises, Q + f where it has fallen by 2*f, held between; y = u(S)",
    &[("headstock-compliance", "a pass from the other end: a spring is the same in it")],
    |[force], machine| machine.friction[Support::Headstock as usize] += force,
);

/// `tailstock-friction`.
pub static TAILSTOCK: Effect<1> = friction(
    "tailstock",
    ["tailstock-friction", "friction holds the joint at the tailstock, which stays behind the force"],
    "at x = L: S = Q - f where Q rises, Q + f where it has fallen by 2*f, held between; y = u(S)",
    &[
        ("tailstock-offset", "a pass from the other end, or a second force: an offset is the same in both"),
        (
            "tailstock-compliance",
            "a pass from the other end, or more places where it begins: friction leaves a kink there",
        ),
    ],
    |[force], machine| machine.friction[Support::Tailstock as usize] += force,
);

const fn friction(
    unit: &'static str,
    [name, about]: [&'static str; 2],
    law: &'static str,
    look_alikes: &'static [(&'static str, &'static str)],
    act: fn([f64; 1], &mut Machine),
) -> Effect<1> {
    Effect {
        name,
        about,
        law,
        source: "Coulomb's law beside the joint, the play operator",
        belongs: Belongs::Unit(unit, UnitRole::Friction),
        odds: Odds::of(0.1, "clamped joints hardly slide under a finishing cut"),
        parameters: [Parameter::amplitude("force", FORCE, "friction f", (1.0, 500.0))],
        look_alikes,
        // In a chuck alone the reaction is the force all along the pass, and friction a step that a setting is too.
        needs: a_tailstock,
        act,
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::{Turning, condense, deflections};
    use super::super::bench::*;
    use crate::process::{Assembled, with_effects};

    /// What the tailstock gives way at places (mm) of a pass, um: 500 N, 50 N/um, 60 N of friction.
    fn tailstock(pass: &str, places: &[f64]) -> Vec<f64> {
        let text = model("centres").replace("cut = { ", &format!("cut = {{ {pass}"));
        let both: [(&str, &[f64]); 2] = [("tailstock-compliance", &[50.0]), ("tailstock-friction", &[60.0])];
        let lathe: Assembled<Turning> = with_effects(&text, &both);
        let x: Vec<f64> = places.iter().map(|x| 1e-3 * x).collect();
        let shaft = condense(lathe.machine(), &x).unwrap();
        let all = deflections(lathe.machine(), &shaft, &x, &Default::default()).unwrap();
        all.iter().map(|d| 1e6 * d.supports.displacements[1]).collect()
    }

    #[test]
    fn it_shows_from_where_the_tool_came() {
        let close = |found: Vec<f64>, expected: [f64; 4]| {
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?} and not {expected:?}");
        };
        // Q = 100, 350, 400 and 500 N. From the tailstock: held at 440 N until Q is below 380 N, then Q + 60 N.
        close(tailstock("", &[120.0, 420.0, 480.0, 600.0]), [3.2, 8.2, 8.8, 8.8]);
        // From the headstock: the pass before left 60 N; held until Q is above 120 N, then Q - 60 N.
        let rising = "from = \"0 mm\", to = \"600 mm\", ";
        close(tailstock(rising, &[120.0, 420.0, 480.0, 600.0]), [1.2, 5.8, 6.8, 8.8]);
    }
}
