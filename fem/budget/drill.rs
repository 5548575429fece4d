//! A hole takes the size of its drill: T = a_max + T_i + Δ_и − a_min [seed 002 (41)], and the same the other way round.

/// A hole made by a tool of its size. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drill {
    /// a_max, by how much the hole is wider than the largest drill.
    pub widening_max: f64,
    /// a_min, by how much it is wider than the smallest worn drill.
    pub widening_min: f64,
    /// T_i, tolerance of the drill.
    pub drill_tolerance: f64,
    /// Δ_и, wear that is allowed.
    pub wear: f64,
    /// T, tolerance of the hole.
    pub tolerance: f64,
    /// Which of the three was not given, and follows from the others.
    pub unknown: Option<Unknown>,
}

/// What follows from the rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// T.
    Tolerance,
    /// T_i.
    DrillTolerance,
    /// Δ_и.
    Wear,
}

impl Drill {
    /// From widenings and at least two of drill tolerance, wear and tolerance of the hole.
    pub fn new(widening: (f64, f64), drill: Option<f64>, wear: Option<f64>, tolerance: Option<f64>) -> Option<Self> {
        let (widening_max, widening_min) = widening;
        let spread = widening_max - widening_min;
        let (drill_tolerance, wear, tolerance, unknown) = match (drill, wear, tolerance) {
            (Some(d), Some(w), None) => (d, w, spread + d + w, Some(Unknown::Tolerance)),
            (None, Some(w), Some(t)) => (t - spread - w, w, t, Some(Unknown::DrillTolerance)),
            (Some(d), None, Some(t)) => (d, t - spread - d, t, Some(Unknown::Wear)),
            (Some(d), Some(w), Some(t)) => (d, w, t, None),
            _ => return None,
        };
        Some(Self { widening_max, widening_min, drill_tolerance, wear, tolerance, unknown })
    }

    /// What the hole's size varies by, m.
    pub fn total(&self) -> f64 {
        self.widening_max + self.drill_tolerance + self.wear - self.widening_min
    }

    /// What is left of the hole's tolerance, m; below zero where it does not suffice.
    pub fn left(&self) -> f64 {
        self.tolerance - self.total()
    }
}
