//! The validation table of heated bodies: closed forms and series of conduction, published benchmarks,
//! growth and bow, cooling, recorded inputs and heaters.

mod benchmarks;
mod cooling;
mod effects;
mod inputs;
mod plates;
mod rig;
mod series;
mod surroundings;

use crate::validation::Case;

/// Every case.
pub fn cases() -> Vec<Case> {
    let all = [series::cases(), effects::cases(), benchmarks::cases(), plates::cases(), cooling::cases()];
    [all.concat(), inputs::cases(), surroundings::cases()].concat()
}
