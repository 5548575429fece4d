//! The level of the tests.

/// Significance level: a model is adequate when the p-value of its χ² is no smaller and no structure is
/// significant.
pub const SIGNIFICANCE: f64 = 0.01;
