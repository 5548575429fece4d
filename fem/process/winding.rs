//! Elastic clearance: friction on a slide winds up what drives it before anything moves.

use super::Nut;
use crate::solve::Bar;

/// A drive that friction winds up: bearing, screw and nut in series [seed 000, fig. 2b and 5].
#[derive(Clone, Debug, PartialEq)]
pub struct Winding {
    /// Friction F of the slide, N.
    pub friction: f64,
    /// Stiffness C_n of bearing, nut and their seats, N/m; without a nut that is preloaded.
    pub stiffness: f64,
    /// What does not depend on the place, m: F/C_n of bearing, nut and their seats, or of the bearing and a preloaded
    /// nut by its own law.
    steady: f64,
    screw: Bar,
}

impl Winding {
    /// A drive whose bearing and nut together have a stiffness (N/m), or the bearing alone beside a preloaded nut.
    pub fn new(friction: f64, stiffness: f64, screw: Bar, nut: Option<&Nut>) -> Self {
        let nut = nut.map_or(0.0, |nut| nut.displacement(friction));
        Self { friction, stiffness, steady: friction / stiffness + nut, screw }
    }

    /// How far friction holds the slide back where it stands at x (m): F/C(x), 1/C(x) = 1/C_n + |x - x_b|/(EA), m.
    pub fn displacement(&self, x: f64) -> f64 {
        self.steady + self.friction * self.screw.compliance(x)
    }
}
