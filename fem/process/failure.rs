//! How a computation tells that it has no answer.

/// A computation that gave no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// What happened.
    pub message: String,
    /// What to change.
    pub help: String,
}
