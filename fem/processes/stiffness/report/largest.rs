//! The largest displacement, and under which force.

use super::super::rows::FORCE_OF_ROW;
use crate::process::{Figure, Forward, first_extreme};
use crate::units::{FORCE, MICRO};

pub fn largest(forward: &Forward) -> Figure {
    let row = first_extreme(forward.prediction, |a, b| a.abs() > b.abs());
    let (value, force) = (forward.prediction[row], forward.programme.columns[FORCE_OF_ROW][row]);
    Figure::new("largest", "largest displacement")
        .quantity("value", MICRO, value)
        .quantity("force", FORCE, force)
        .line(format!("{:+.3} at {:.1}", MICRO.shown(value), FORCE.shown(force)))
}
