//! The validation table of rings: what series, closed forms and benchmarks say, and what the program
//! computes from a model file.

mod benchmark;
mod effects;
mod inside;
mod membrane;
mod michell;
mod rig;
mod roundness;
mod thin;
mod wide;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [
        thin::cases(),
        michell::cases(),
        benchmark::cases(),
        effects::cases(),
        roundness::cases(),
        inside::cases(),
        membrane::cases(),
        wide::cases(),
    ]
    .concat()
}
