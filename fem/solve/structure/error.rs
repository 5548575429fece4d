//! Errors of structures.

use super::{Direction, Freedom};

/// A structure that cannot be solved.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum StructureError {
    /// Nothing resists a motion; the freedom that moves most in it.
    #[error("nothing holds node {} {}", .0.node, way(.0.direction))]
    Loose(Freedom),
    /// The factorisation did not fit into memory.
    #[error("out of memory in the factorisation of {unknowns} unknowns")]
    OutOfMemory {
        /// Number of unknowns.
        unknowns: usize,
    },
}

/// A direction in words.
pub(super) fn way(direction: Direction) -> &'static str {
    match direction {
        Direction::X => "along x",
        Direction::Y => "along y",
        Direction::Turn => "against turning",
    }
}
