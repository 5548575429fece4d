//! Size of a drilled hole: T = a_max + T_i + Δ_и − a_min [seed 002 (41)], solved for any of T, T_i and Δ_и.

/// Hole made by a tool of its size. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drill {
    /// Widening a_max of the hole over the largest drill.
    pub widening_max: f64,
    /// Widening a_min of the hole over the smallest worn drill.
    pub widening_min: f64,
    /// Tolerance T_i of the drill.
    pub drill_tolerance: f64,
    /// Allowed wear Δ_и.
    pub wear: f64,
    /// Tolerance T of the hole.
    pub tolerance: f64,
    /// Quantity that was not given and follows from the others, if one was not.
    pub unknown: Option<Unknown>,
}

/// Quantity that follows from the others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unknown {
    /// Tolerance T of the hole.
    Tolerance,
    /// Tolerance T_i of the drill.
    DrillTolerance,
    /// Wear Δ_и.
    Wear,
}

impl Drill {
    /// Solves for the unknown, from widenings and at least two of drill tolerance, wear and tolerance of the
    /// hole.
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

    /// Variation of the size of the hole, m.
    pub fn total(&self) -> f64 {
        self.widening_max + self.drill_tolerance + self.wear - self.widening_min
    }

    /// Rest of the tolerance of the hole, m; below zero where it does not suffice.
    pub fn left(&self) -> f64 {
        self.tolerance - self.total()
    }
}
