//! Clearance in series with what yields: the one law of lost motion, by which joints under test, feed axes and the
//! axes of a contour go.
//!
//! A joint presses on the one flank or on the other, by the sign of the force S that it transmits, and crosses the
//! clearance where S changes its sign. Dry friction comes first: it says which S is left of a force, or, of a slide that
//! is driven, that S is the friction, against the motion. Counted from the flank on which S < 0 presses.

/// How far a joint gives way (m) that bends by `bend` (m, of the sign of the force) and presses on a flank by the force
/// `s` (N, or any number of its sign): by the clearance (m) too on the far flank. Nothing is crossed without a force.
pub fn give_way(clearance: f64, bend: f64, s: f64) -> f64 {
    if s > 0.0 { bend + clearance } else { bend }
}

/// Lost motion (m) of such a joint at a reversal of the force, which bends it by `bend` (m) on either flank.
pub fn lost_motion(clearance: f64, bend: f64) -> f64 {
    give_way(clearance, bend, 1.0) - give_way(clearance, -bend, -1.0)
}
