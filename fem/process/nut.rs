//! The nut of a screw drive: two halves that press on each other, which leaves no clearance between screw and
//! slide, only what the halves yield [seed 000, fig. 5].

use super::{Figure, estimates};
use crate::input::{Bounds, Reader};
use crate::joint::{Joint, Pair};
use crate::units::{CONTACT_COEFFICIENT, FORCE, NUMBER, STIFFNESS};

/// A preloaded nut.
#[derive(Clone, Debug, PartialEq)]
pub struct Nut {
    /// How each half yields.
    half: Joint,
    /// Force with which the halves press on each other, N.
    preload: f64,
}

impl Nut {
    /// Reads `nut` of a screw's table; `None` where it is left out.
    pub fn read(screw: &Reader) -> Option<Self> {
        screw.optional_table("nut", "its nut, of two halves that press on each other", |t| {
            let preload =
                t.quantity("preload", FORCE, "with which the halves press on each other").estimated(estimates::PRELOAD);
            let preload = preload.positive().required();
            let stiffness = t.quantity("stiffness", STIFFNESS, "of the spring in each half; rigid if left out");
            let contact = t.quantity("c", CONTACT_COEFFICIENT, "coefficient of the contact in each half, c*Q^n");
            let stiffness = stiffness.estimated(estimates::STIFFNESS).positive().optional();
            let contact = contact.estimated(estimates::CONTACT).not_negative().optional();
            let exponent = t.quantity("n", NUMBER, "exponent of that contact").bounds(Bounds::Within(0.0, 1.0)).or(0.5);
            if stiffness.is_none() && contact.is_none() {
                let help = "add stiffness = \"400 N/um\", or the contact c = \"0.2 um/N^n\" with n = 0.5";
                t.problem("", "the nut does not say how its halves yield", help);
            }
            let mut half = Joint::default();
            half.soften(stiffness.unwrap_or(f64::INFINITY));
            half.add_contact(contact.unwrap_or(0.0), exponent);
            Self { half, preload }
        })
    }

    /// How far it yields under a force on the slide (N), m.
    pub fn displacement(&self, force: f64) -> f64 {
        Pair::new(&self.half, self.preload).displacement(force)
    }

    /// Tangent stiffness without a force, N/m.
    pub fn stiffness(&self) -> f64 {
        1.0 / Pair::new(&self.half, self.preload).compliance(0.0)
    }

    /// Figure of the stiffness that its preload gives.
    pub fn figure(&self) -> Figure {
        let stiffness = self.stiffness();
        let line = format!("{:.1} under a preload of {}", STIFFNESS.shown(stiffness), FORCE.format(self.preload));
        let figure = Figure::new("nut", "nut").line(line);
        figure.quantity("stiffness", STIFFNESS, stiffness).quantity("preload", FORCE, self.preload)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn nut(stiffness: f64, coefficient: f64) -> Nut {
        let mut half = Joint::default();
        half.soften(stiffness);
        half.add_contact(coefficient, 0.5);
        Nut { half, preload: 400.0 }
    }

    #[test]
    fn two_springs_share_the_force_until_one_is_relaxed() {
        // 100 N/um each: F/2k up to F = 2P, F/k - P/k beyond.
        let nut = nut(1e8, 0.0);
        for (force, expected) in [(600.0, 3e-6), (-600.0, -3e-6), (1000.0, 6e-6)] {
            assert!((nut.displacement(force) - expected).abs() < 1e-18, "{force}");
        }
        assert!((nut.stiffness() - 2e8).abs() < 1e-6);
    }

    #[test]
    fn two_contacts_are_straight_while_both_press() {
        // u = c*sqrt(Q): the sum of the roots stays 2*sqrt(P), so that y = c*F/(4*sqrt(P)).
        let nut = nut(f64::INFINITY, 0.25e-6);
        assert!((nut.displacement(600.0) - 0.25e-6 * 600.0 / 80.0).abs() < 1e-15);
        assert!((nut.stiffness() / (80.0 / 0.25e-6) - 1.0).abs() < 1e-12);
    }
}
