//! Where values must lie.

/// Range in which a value must lie, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bounds {
    /// Anywhere.
    Any,
    /// Above zero.
    Positive,
    /// Zero or more.
    NotNegative,
    /// Above the first, at most the second.
    Within(f64, f64),
}

impl Bounds {
    /// Whether a value may be taken.
    pub fn admits(self, value: f64) -> bool {
        match self {
            Self::Any => true,
            Self::Positive => value > 0.0,
            Self::NotNegative => value >= 0.0,
            Self::Within(low, high) => value > low && value <= high,
        }
    }

    /// The ends between which it must lie; infinite where there is none.
    pub fn ends(self) -> (f64, f64) {
        match self {
            Self::Any => (f64::NEG_INFINITY, f64::INFINITY),
            Self::Positive | Self::NotNegative => (0.0, f64::INFINITY),
            Self::Within(low, high) => (low, high),
        }
    }
}
