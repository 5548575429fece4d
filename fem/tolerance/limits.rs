//! Limits of a size or a form.

/// Limits of a size, as deviations from the nominal one, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The smallest deviation that is allowed.
    pub lower: f64,
    /// The largest.
    pub upper: f64,
}

impl Limits {
    /// From nothing up to a width: of what is never below zero, as deviations of form are.
    pub fn up_to(width: f64) -> Self {
        Self { lower: f64::NEG_INFINITY, upper: width }
    }

    /// Whether a range of deviations lies within them.
    pub fn hold(&self, [low, high]: [f64; 2]) -> bool {
        self.lower <= low && high <= self.upper
    }

    /// The same limits about a size.
    #[must_use]
    pub fn about(&self, size: f64) -> Self {
        Self { lower: self.lower + size, upper: self.upper + size }
    }

    /// The deviation that is farthest from both limits; none of one limit alone.
    pub fn middle(&self) -> Option<f64> {
        Some(0.5 * (self.lower + self.upper)).filter(|middle| middle.is_finite())
    }
}
