//! The validation table of contours: what closed forms, first-order formulas and stepping through time say,
//! and what the program computes from a model file.

mod effects;
mod elastic;
mod following;
mod play;
mod polygon;
mod rectangle;
mod rig;
mod servo;
mod standard;
mod stepping;

use crate::validation::Case;

/// All cases, simple ones first.
pub fn cases() -> Vec<Case> {
    [
        servo::cases(),
        play::cases(),
        effects::cases(),
        elastic::cases(),
        following::cases(),
        rectangle::cases(),
        polygon::cases(),
        stepping::cases(),
        standard::cases(),
    ]
    .concat()
}
