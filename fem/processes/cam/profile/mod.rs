//! The profile of a cam: a closed curve about the cam's axis, walked from its start in the order of the model
//! file.
//!
//! A place is told by s, the length of curve from the start (within an interval of a lift table in proportion
//! to the angle). Every polar angle about the axis meets the curve once.

mod chain;
mod closed;
mod curve;
mod lift;
mod plane;
mod table;

pub use chain::{Drawn, MOST_BLOCKS, Segment, read_chain};
pub use closed::Profile;
pub use plane::{Place, Vector, direction, left, turn};
pub use table::read_table;

#[cfg(test)]
mod tests;
