//! The validation table of cams: numbers that the source prints, and closed forms of simple profiles.

mod circles;
mod effects;
mod flanks;
mod printed;
mod programme;
mod rig;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [circles::cases(), flanks::cases(), effects::cases(), printed::cases(), programme::cases()].concat()
}
