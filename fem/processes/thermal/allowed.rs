//! What a drawing allows what is predicted.

use crate::process::AllowedWords;
use crate::units::MICRO;

/// The words for it.
pub const ALLOWED: AllowedWords =
    AllowedWords { within: "length", about: "limits of the growth: ±10 um, 0 um to 20 um", form: None, kind: MICRO };
