//! Why there is no diagnosis.

use crate::process::Failure;

/// The model cannot be computed where it fits best.
pub fn unsolvable() -> Failure {
    Failure {
        message: "the model cannot be computed about its best values".into(),
        help: "give the parameters values from which `fem run` works".into(),
    }
}
