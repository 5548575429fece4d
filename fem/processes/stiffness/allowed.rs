//! What a drawing allows what is predicted.

use crate::process::AllowedWords;
use crate::units::MICRO;

/// The words for it.
pub const ALLOWED: AllowedWords = AllowedWords {
    within: "displacement",
    about: "limits of the displacement at every force: ±10 um",
    form: None,
    kind: MICRO,
};
