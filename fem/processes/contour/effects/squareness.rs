//! The y axis leans towards x.
//!
//! x += angle·y, angle in rad, positive where the angle between the axes is below 90°: (angle·R/2)·sin 2α
//! on a circle, the same both ways round.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::SLOPE;

/// `squareness`.
pub static SQUARENESS: Effect<1> = Effect {
    name: "squareness",
    about: "the axes are not square to each other, and a circle becomes an ellipse at 45 deg",
    law: "x += angle*y: (angle*R/2)*sin(2*alpha), the same ccw and cw",
    source: "geometry of two axes",
    belongs: Belongs::Machine,
    odds: Odds::of(0.7, "no two axes are exactly square"),
    parameters: [Parameter::signed("angle", SLOPE, "what y leans towards x", (-200.0, 200.0))],
    look_alikes: &[("servo-mismatch", "the other way round, or another feed: squareness stays as it is")],
    needs: nothing,
    act: |[angle], machine| machine.squareness = angle,
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn both_ways_round_are_the_same() {
        for direction in DIRECTIONS {
            // 40 um/m of 150 mm: 3 um. The lag of 1/450 rad turns it by as much.
            assert!((change("squareness", &[40.0], direction, 45.0) - 3.0).abs() < 3.0 / 450.0);
        }
    }
}
