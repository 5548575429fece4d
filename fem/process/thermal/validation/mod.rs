//! The validation table of heated bodies: closed forms and series of conduction, published benchmarks,
//! growth and bow.

mod benchmarks;
mod effects;
mod plates;
mod rig;
mod series;

use crate::process::Case;

/// Every case.
pub fn cases() -> Vec<Case> {
    [series::cases(), effects::cases(), benchmarks::cases(), plates::cases()].concat()
}
