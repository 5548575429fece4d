//! The validation table of rotary axes: periods and sizes of the errors of worm, gears and scale, the equilibrium of torques,
//! friction, spring and play, and positioning tests whose evaluation is known.

mod compensation;
mod equilibrium;
mod errors;
mod rig;
mod standard;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [errors::cases(), equilibrium::cases(), standard::cases(), compensation::cases()].concat()
}
