//! Errors of structures.

use super::{Direction, Freedom};

/// A structure that cannot be solved.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum StructureError {
    /// Nothing resists a motion.
    #[error("nothing holds node {} {}", at.node, way(at.direction))]
    Loose {
        /// The freedom that moves most in it.
        at: Freedom,
        /// How many nodes move along with it, as far or nearly so; 1 where it is alone.
        nodes: usize,
    },
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
