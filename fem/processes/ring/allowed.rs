//! What a drawing allows what is predicted.

use crate::process::AllowedWords;
use crate::units::MICRO;

/// The words for it.
pub const ALLOWED: AllowedWords = AllowedWords {
    within: "radius",
    about: "limits of the radial deviation: ±10 um, 0 um to 20 um",
    form: Some(("roundness", "largest less smallest radius")),
    kind: MICRO,
};
