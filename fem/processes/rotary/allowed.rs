//! What a drawing allows what is predicted.

use crate::process::AllowedWords;
use crate::units::SMALL_ANGLE;

/// The words for it.
pub const ALLOWED: AllowedWords = AllowedWords {
    within: "position",
    about: "limits of the deviation at every target: ±10 arcsec",
    form: None,
    kind: SMALL_ANGLE,
};
