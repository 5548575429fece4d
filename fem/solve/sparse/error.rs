//! Errors of a sparse solve.

/// A system that has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SparseError {
    /// A pivot is zero, negative or lost to rounding: something is loose, or a law is not positive.
    #[error("node {node} at ({:.6}, {:.6}) m moves without resistance in component {component}", .at[0], .at[1])]
    Singular {
        /// The node, from 0.
        node: usize,
        /// Place of the node (m).
        at: [f64; 2],
        /// Component of the freedom at this node, from 0.
        component: usize,
    },
    /// The matrix has an entry that is infinite or not a number.
    #[error("element {element} has a matrix that is not finite")]
    NotFinite {
        /// The element, from 0.
        element: usize,
    },
    /// A load or prescribed value is infinite or not a number.
    #[error("load {value} on node {node}")]
    Load {
        /// The node, from 0.
        node: usize,
        /// The value given.
        value: f64,
    },
    /// The solution does not satisfy the equations.
    #[error("solution leaves a residual of {residual:.1e} of the load: the system is too ill-conditioned")]
    Inaccurate {
        /// Largest entry of the residual over the largest of |A||x| + |b|.
        residual: f64,
    },
    /// No memory for the factor.
    #[error("out of memory in the factorisation of {unknowns} unknowns")]
    OutOfMemory {
        /// Number of unknowns.
        unknowns: usize,
    },
}

/// Why there is no factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FactorError {
    /// The pivot of this number is zero, negative or not a number.
    Pivot(usize),
    OutOfMemory,
}
