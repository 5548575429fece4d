//! Errors of an elastic solve.

use std::fmt;

use crate::mesh::MeshError;
use crate::solve::sparse::SparseError;

/// A motion that no support resists.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LooseMotion {
    /// The body can slide in this direction (unit vector).
    Slide([f64; 2]),
    /// The body can turn about this place (m).
    Turn([f64; 2]),
}

impl fmt::Display for LooseMotion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Slide([x, y]) => write!(f, "slide along ({x:.3}, {y:.3})"),
            Self::Turn([x, y]) => write!(f, "turn about ({x:.6}, {y:.6}) m"),
        }
    }
}

/// An elastic problem without an answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ElasticError {
    /// The mesh cannot be used.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The equations cannot be solved.
    #[error(transparent)]
    Sparse(#[from] SparseError),
    /// The supports leave a piece of the mesh a motion without resistance.
    #[error("the body of element {element} is loose: it can {motion}")]
    Loose {
        /// An element of the loose piece, from 0.
        element: usize,
        /// The motion that is left to it.
        motion: LooseMotion,
    },
    /// A prescribed displacement refers to a node that does not exist, or twice to one freedom.
    #[error("prescribed displacement of node {node}: {reason}")]
    Prescribed {
        /// The node.
        node: usize,
        /// Why it cannot be prescribed.
        reason: &'static str,
    },
    /// The loads of a free body are not in equilibrium.
    #[error(
        "loads on a free body are not in equilibrium: they add up to ({:.3e}, {:.3e}) N and {moment:.3e} N m",
        .force[0], .force[1]
    )]
    Unbalanced {
        /// Sum of the forces, N.
        force: [f64; 2],
        /// Sum of the moments about the middle of the body, N m.
        moment: f64,
    },
    /// The constraints that only take rigid motion away carry a force.
    #[error("the constraint of node {node} carries {force:.3e} N, and should carry nothing")]
    Carries {
        /// The node.
        node: usize,
        /// The force, N.
        force: f64,
    },
}
