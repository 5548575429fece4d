//! How a computation tells that it has no answer.

/// A computation that gave no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// Cause, as a sentence.
    pub message: String,
    /// Remedy: the inputs to change.
    pub help: String,
}
