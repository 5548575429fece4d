//! The chuck and the cut as effects shape them.

use std::sync::Arc;

use super::model::Setup;

/// A point of the bore of a ring in a set-up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// From jaw 1, rad.
    pub angle: f64,
    /// Of the ring's mark from jaw 1, rad.
    pub orientation: f64,
    /// Radial deviation of the bore before boring, m.
    pub blank: f64,
}

/// A radial deviation of the released bore that does not depend on the jaws, m.
pub type Mark = Box<dyn Fn(&Place) -> f64 + Send + Sync>;

/// A chuck and a cut with their effects. Effects act by moving jaws, by spreading or taking away their force, or by leaving a mark on the bore.
pub struct Machine {
    /// What the model says.
    pub setup: Arc<Setup>,
    /// Where the jaws stand, rad.
    pub jaws: Vec<f64>,
    /// Full angle over which each presses, rad; 0 for a line load.
    pub arc: f64,
    /// Σ m·r of a jaw, which the spindle's turning pulls outwards, kg·m.
    pub jaw_moment: f64,
    /// Deviations of the bored and released ring that add up.
    pub marks: Vec<Mark>,
}

impl Machine {
    /// The ideal machine: jaws where the model has them, evenly spaced and each pressing along a line unless a mesh says otherwise; the spindle true and cold.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let (jaws, arc) = (setup.places(), setup.arc());
        Self { setup, jaws, arc, jaw_moment: 0.0, marks: Vec::new() }
    }

    /// Adds a deviation of the released bore, m.
    pub fn mark(&mut self, mark: impl Fn(&Place) -> f64 + Send + Sync + 'static) {
        self.marks.push(Box::new(mark));
    }

    /// Force of a jaw while the spindle turns at `speed` (rad/s), from its `force` at standstill (N): F = max(0, F₀ − m·r·ω²).
    pub fn force_at(&self, force: f64, speed: f64) -> f64 {
        (force - self.jaw_moment * speed * speed).max(0.0)
    }

    /// Speed above which the ring is let go, rad/s; infinite where the jaws do not lighten.
    pub fn let_go(&self) -> f64 {
        if self.jaw_moment > 0.0 { (self.setup.jaw_force / self.jaw_moment).sqrt() } else { f64::INFINITY }
    }
}
