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
