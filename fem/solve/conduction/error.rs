//! Errors of a thermal problem.

use crate::mesh::MeshError;
use crate::solve::sparse::SparseError;

/// A thermal problem without an answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ThermalError {
    /// The mesh cannot be used, or has no such sides.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The equations cannot be solved.
    #[error(transparent)]
    Sparse(#[from] SparseError),
    /// A value is out of range.
    #[error("{quantity} must be {range}, not {value}")]
    Value {
        /// The quantity and its unit.
        quantity: &'static str,
        /// The values that it may have.
        range: &'static str,
        /// The value given.
        value: f64,
    },
    /// The node of a source does not exist.
    #[error("heat source on node {node}: the mesh has nodes 0 to {last}")]
    UnknownNode {
        /// The node asked for.
        node: usize,
        /// The last node.
        last: usize,
    },
    /// The number of temperatures is not that of the nodes.
    #[error("{given} initial temperatures for {nodes} nodes")]
    Initial {
        /// Temperatures given.
        given: usize,
        /// Nodes of the mesh.
        nodes: usize,
    },
    /// A stage of a step found no temperatures at which a surface loses what comes in.
    #[error("no temperatures were found at which the surfaces lose what they are given, {time} s after the start")]
    NoBalance {
        /// Begin of the step, s.
        time: f64,
    },
    /// The body is warmer or colder than its properties are known.
    #[error("properties are known {:.1} to {:.1} K above the start, and the body is {:.1} to {:.1} K above it at {time} s", known[0], known[1], reached[0], reached[1])]
    Unknown {
        /// End of the step, s.
        time: f64,
        /// Rises of the coldest and of the hottest node, K.
        reached: [f64; 2],
        /// Rises between which all properties are known, K.
        known: [f64; 2],
    },
    /// Nothing holds the temperature of a piece of the mesh, so that it has no steady state.
    #[error("the body of element {element} is insulated: its steady temperature is undetermined")]
    Insulated {
        /// An element of the piece, from 0.
        element: usize,
    },
}

impl ThermalError {
    /// Passes where `holds`.
    pub(super) fn check(
        holds: bool,
        quantity: &'static str,
        range: &'static str,
        value: f64,
    ) -> Result<(), ThermalError> {
        if holds { Ok(()) } else { Err(Self::Value { quantity, range, value }) }
    }
}
