//! How a computation tells that it has no answer.

use crate::solve::JointsError;

/// A computation that gave no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// Cause, as a sentence.
    pub message: String,
    /// Remedy: the inputs to change.
    pub help: String,
}

impl From<JointsError> for Failure {
    fn from(error: JointsError) -> Self {
        let help = "check force, stiffnesses and contact parameters: values far from physical ones do not converge";
        Self { message: error.to_string(), help: help.into() }
    }
}
