//! Errors of a frame and of its solve.

use super::solution::Convergence;
use super::support::LooseMotion;

/// A frame that cannot be built.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FrameError {
    /// The list of pieces is empty.
    #[error("the shaft has no pieces")]
    NoPieces,
    /// A length or rigidity is not positive (or not finite where it must be).
    #[error("piece {piece}: {quantity} must be positive, not {value}")]
    Piece {
        /// Index of the piece, from 0.
        piece: usize,
        /// The quantity and its unit.
        quantity: &'static str,
        /// The value given.
        value: f64,
    },
    /// The node does not exist.
    #[error("there is no node {node}: the shaft has nodes 0 to {last}")]
    UnknownNode {
        /// The node asked for.
        node: usize,
        /// The last node.
        last: usize,
    },
    /// A spring stiffness is negative or not a number.
    #[error("node {node}: a spring stiffness must not be negative, not {value}")]
    Spring {
        /// The node of the spring.
        node: usize,
        /// The value given (N/m or N m/rad).
        value: f64,
    },
    /// A fixed degree of freedom can carry no second support: the two reactions would be undetermined.
    #[error("node {node} is fixed and has another support in the same direction")]
    DoubleSupport {
        /// The node.
        node: usize,
    },
}

/// A solve that gave no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// The supports leave the shaft a motion without resistance.
    #[error("shaft is {0}")]
    Loose(LooseMotion),
    /// A load stands on a node that does not exist.
    #[error("load on node {node}: the shaft has nodes 0 to {last}")]
    UnknownNode {
        /// The node asked for.
        node: usize,
        /// The last node.
        last: usize,
    },
    /// A load is infinite or not a number.
    #[error("load on node {node} is {force} N")]
    Load {
        /// The loaded node.
        node: usize,
        /// The value given (N).
        force: f64,
    },
    /// Only a frame without nonlinear joints can be factored once for all loads.
    #[error("a frame with nonlinear joints cannot be factored once: solve each load by itself")]
    Nonlinear,
    /// The stiffness lost its positive pivot: supports too soft for the stiffness of so many short elements.
    #[error(
        "stiffness is not positive definite in double precision at node {node}: supports too soft or elements too short"
    )]
    NotPositiveDefinite {
        /// Node of the failed pivot.
        node: usize,
    },
    /// The factorisation did not fit into memory.
    #[error("out of memory in the factorisation of {unknowns} unknowns")]
    OutOfMemory {
        /// Number of unknowns.
        unknowns: usize,
    },
    /// The iteration ended without meeting the convergence test.
    #[error("no convergence: {0}")]
    NotConverged(Convergence),
}
