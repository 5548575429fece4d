//! How a Gmsh file is wrong.

use crate::mesh::MeshError;

/// A Gmsh file that cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GmshError {
    /// Not the format.
    #[error("this is no Gmsh mesh of format 4.1 (write it with `gmsh -2 -format msh41`): {0}")]
    Format(String),
    /// A section is cut short or holds something else than numbers.
    #[error("{section}, {place}: {problem}")]
    Syntax {
        /// The section.
        section: &'static str,
        /// Line (text) or byte (binary).
        place: String,
        /// The mistake.
        problem: String,
    },
    /// An element of a kind that is not plane, or not known here.
    #[error("element {tag} is of Gmsh type {kind}; known are tri3, tri6, quad4, quad8, quad9 (types 2, 9, 3, 16, 10)")]
    Kind {
        /// Tag of the element in the file.
        tag: u64,
        /// Gmsh's number of the type.
        kind: i32,
    },
    /// An element refers to a node that is not in the file.
    #[error("element {element} has a node {node} that the file does not hold")]
    UnknownNode {
        /// Tag of the element in the file.
        element: u64,
        /// Tag of the node.
        node: u64,
    },
    /// A node is off the plane.
    #[error("node {node} is off the plane z = 0 by {z:.3e}")]
    OffPlane {
        /// Tag of the node in the file.
        node: u64,
        /// z in the unit of the file.
        z: f64,
    },
    /// A physical curve does not follow the sides of elements.
    #[error("element {element} of the physical curve `{name}` is not a side of a plane element")]
    LooseLine {
        /// Name of the curve.
        name: String,
        /// Tag of the line element in the file.
        element: u64,
    },
    /// A physical point is no node of an element.
    #[error("element {element} of the physical point `{name}` is at no node of a plane element")]
    LoosePoint {
        /// Name of the point.
        name: String,
        /// Tag of the point element in the file.
        element: u64,
    },
    /// The elements are not a mesh; elements and nodes by their tags.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}
