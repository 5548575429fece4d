//! The validation table of joints under test: laws by hand, tangents by finite differences, and loops by
//! their polygons and by quadrature.

mod curves;
mod loops;
mod rig;

use crate::process::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [curves::cases(), loops::cases()].concat()
}
