//! Errors of a mesh.

/// A mesh that cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// The mesh has no elements.
    #[error("the mesh has no elements")]
    Empty,
    /// A coordinate is not a number.
    #[error("node {node} is at ({}, {}) m", .at[0], .at[1])]
    NotFinite {
        /// The node, from 0.
        node: usize,
        /// The coordinates given (m).
        at: [f64; 2],
    },
    /// A list of nodes does not divide into elements.
    #[error("{count} nodes do not divide into {kind} elements")]
    Ragged {
        /// The element's name.
        kind: &'static str,
        /// Length of the list.
        count: usize,
    },
    /// An element refers to a node that does not exist.
    #[error("element {element} has a node {node}: the mesh has nodes 0 to {last}")]
    UnknownNode {
        /// The element, from 0.
        element: usize,
        /// The node that it refers to.
        node: u32,
        /// The last node.
        last: usize,
    },
    /// An element is inside out, folded or flat.
    #[error(
        "element {element} ({kind}) near ({:.6}, {:.6}) m is inside out, folded or flat: its smallest Jacobian is \
         {distortion:.3} of the mean", .at[0], .at[1]
    )]
    Inverted {
        /// The element, from 0.
        element: usize,
        /// The element's name.
        kind: &'static str,
        /// One of its nodes (m).
        at: [f64; 2],
        /// Smallest determinant of the Jacobian over the mean.
        distortion: f64,
    },
    /// A node belongs to no element.
    #[error("node {node} at ({:.6}, {:.6}) m belongs to no element", .at[0], .at[1])]
    Unused {
        /// The node, from 0.
        node: usize,
        /// Place of the node (m).
        at: [f64; 2],
    },
    /// A named side does not exist.
    #[error("`{name}` names side {side} of element {element}, which does not exist")]
    UnknownSide {
        /// Name of the group of sides.
        name: String,
        /// The element.
        element: u32,
        /// The side of the element.
        side: u8,
    },
    /// No sides have this name.
    #[error("the mesh has no sides called `{name}`; it has {known}")]
    UnknownName {
        /// The name asked for.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// The parts of the mesh do not hang together.
    #[error("the mesh falls into {pieces} pieces: element {element} is not connected to element {other}")]
    Disconnected {
        /// Number of pieces.
        pieces: usize,
        /// An element of the first piece.
        other: usize,
        /// An element of the second.
        element: usize,
    },
    /// A structured mesh cannot be made of these numbers.
    #[error("{quantity} must be {range}, not {value}")]
    Parameter {
        /// The quantity and its unit.
        quantity: &'static str,
        /// The values that it may have.
        range: String,
        /// The value given.
        value: f64,
    },
}

impl MeshError {
    /// The same with the numbers that elements and nodes have in a file.
    #[must_use]
    pub(super) fn renumbered(mut self, elements: &[u64], nodes: &[u64]) -> Self {
        let of = |tags: &[u64], number: &mut usize| *number = tags.get(*number).map_or(*number, |&tag| tag as usize);
        match &mut self {
            Self::Inverted { element, .. } | Self::UnknownNode { element, .. } => of(elements, element),
            Self::Disconnected { element, other, .. } => {
                of(elements, element);
                of(elements, other);
            }
            Self::NotFinite { node, .. } | Self::Unused { node, .. } => of(nodes, node),
            _ => {}
        }
        self
    }

    pub(super) fn parameter(quantity: &'static str, range: impl Into<String>, value: f64) -> Self {
        Self::Parameter { quantity, range: range.into(), value }
    }
}
