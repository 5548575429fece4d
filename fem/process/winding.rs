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
    /// Part of the wind-up that does not depend on the place, m: F/C_n of bearing, nut and their seats, or of the
    /// bearing and a preloaded nut by its own law.
    steady: f64,
    screw: Bar,
    nut: Option<Nut>,
}

impl Winding {
    /// A drive whose bearing and nut together have a stiffness (N/m), or the bearing alone beside a preloaded nut.
    pub fn new(friction: f64, stiffness: f64, screw: Bar, nut: Option<&Nut>) -> Self {
        let mut winding = Self { friction, stiffness, steady: 0.0, screw, nut: nut.cloned() };
        winding.steady = winding.steady_under(friction);
        winding
    }

    fn steady_under(&self, force: f64) -> f64 {
        force / self.stiffness + self.nut.as_ref().map_or(0.0, |nut| nut.displacement(force))
    }

    /// How far friction holds the slide back where it stands at x (m): F/C(x), 1/C(x) = 1/C_n + |x - x_b|/(EA), m.
    pub fn displacement(&self, x: f64) -> f64 {
        self.steady + self.friction * self.screw.compliance(x)
    }

    /// The same under another friction (N), m: that of a place, where it is not the same all along.
    pub fn under(&self, friction: f64, x: f64) -> f64 {
        self.steady_under(friction) + friction * self.screw.compliance(x)
    }
}
