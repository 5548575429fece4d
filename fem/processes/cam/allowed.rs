//! What a drawing allows what is predicted.

use crate::process::AllowedWords;
use crate::units::MICRO;

/// The words for it.
pub const ALLOWED: AllowedWords = AllowedWords {
    within: "deviation",
    about: "limits of the deviation from the profile: ±10 um",
    form: None,
    kind: MICRO,
};
