//! Units, and what is wrong with one that cannot be read.

use super::Dimension;

/// A unit: SI value = number · `factor` + `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// SI units in one of this unit.
    pub factor: f64,
    /// SI value of zero on this unit's scale; only degC has one that is not zero.
    pub offset: f64,
    /// Dimension of the quantity that it measures.
    pub dimension: Dimension,
}

/// Why a text is no quantity or no unit, in words that go after "expected …".
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct UnitError {
    /// The mistake.
    pub message: String,
    /// The remedy, where it is known.
    pub hint: Option<String>,
}

impl UnitError {
    pub(super) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), hint: None }
    }

    pub(super) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }
}
