//! The validation table of turning: what handbooks, closed forms and benchmarks say, and what the program
//! computes from a model file.

mod beams;
mod benchmark;
mod cross_check;
mod events;
mod feedback;
mod geometry;
mod heating;
mod joints;
mod meetings;
mod passes;
mod rig;
mod structure;
mod time;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [
        beams::cases(),
        benchmark::cases(),
        joints::cases(),
        feedback::cases(),
        passes::cases(),
        geometry::cases(),
        meetings::cases(),
        time::cases(),
        events::cases(),
        heating::cases(),
        cross_check::cases(),
        structure::cases(),
    ]
    .concat()
}
