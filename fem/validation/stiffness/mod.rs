//! The validation table of joints under test: laws by hand, preloaded pairs in closed form, tangents by
//! finite differences, loops by their polygons and by quadrature, and a whole machine by another program.

mod curves;
mod loops;
mod pairs;
mod rig;
mod structure;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [curves::cases(), pairs::cases(), loops::cases(), structure::cases()].concat()
}
