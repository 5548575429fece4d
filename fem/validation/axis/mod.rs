//! The validation table of axes: closed forms, effects by hand, and positioning tests whose evaluation is
//! known.

mod compensation;
mod effects;
mod rig;
mod screw;
mod standard;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [screw::cases(), effects::cases(), standard::cases(), compensation::cases()].concat()
}
