//! The validation table of joints under test: laws by hand, preloaded pairs in closed form, tangents by
//! finite differences, and loops by their polygons and by quadrature.

mod curves;
mod loops;
mod pairs;
mod rig;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [curves::cases(), pairs::cases(), loops::cases()].concat()
}
