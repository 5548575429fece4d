//! The level of the tests.

/// Significance level: a model is adequate when the p-value of its χ² is no smaller and no structure is
/// significant. Both are tested, so that of a hundred good models one is called a failing one.
pub const SIGNIFICANCE: f64 = 0.005;
