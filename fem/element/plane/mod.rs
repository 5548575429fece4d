//! Plane elements: shapes (one file each), quadrature, and the weak forms of elasticity and heat conduction in plane
//! bodies and bodies of revolution.
//!
//! An element is data and two functions ([`PlaneElement`]). Everything else (sampling, weak forms, meshes,
//! the property tests) follows from the list [`ALL`]; a new element is one file and one line there.

#![allow(clippy::needless_range_loop, reason = "sums over pairs of nodes read best with their indices")]

mod edge;
mod elasticity;
mod heat;
mod quad4;
mod quad8;
mod quad9;
pub mod quadrature;
mod sampled;
#[cfg(test)]
mod tests;
mod thickness;
mod tri3;
mod tri6;
mod waves;

use std::fmt;

pub use edge::{EDGE_NODES, EdgeCurve, WHOLE, edge_shapes, edge_slopes};
pub use elasticity::{Elasticity, PlaneState, STRAINS};
pub use heat::{Capacity, Conduction};
pub use quad4::Quad4;
pub use quad8::Quad8;
pub use quad9::Quad9;
pub use sampled::{GradientProducts, HoopProducts, Sampled, SampledPoint};
pub use thickness::Thickness;
pub use tri3::Tri3;
pub use tri6::Tri6;

use quadrature::Point;

/// The most nodes an element has; arrays over nodes have this length and zeros at their end.
pub const MAX_NODES: usize = 9;

/// A square array over pairs of an element's nodes, of C × C blocks: `square[a][b][i][j]` couples component i
/// of node a with component j of node b.
pub type Square<const C: usize> = [[[[f64; C]; C]; MAX_NODES]; MAX_NODES];

/// A plane isoparametric element: x(ξ, η) = Σ Nₐ(ξ, η) xₐ.
pub trait PlaneElement: Sync {
    /// Name of the element in messages, such as `quad8`.
    fn name(&self) -> &'static str;

    /// Reference coordinates (ξ, η) of the nodes: corners first, counter-clockwise, then the middles of the
    /// sides in the order of the sides, then the centre. (nodes, 2)
    fn reference(&self) -> &'static [[f64; 2]];

    /// Nodes of each side, counter-clockwise: start, end, and its middle in elements of second order.
    fn edges(&self) -> &'static [&'static [usize]];

    /// Quadrature that integrates stiffness and capacity of an undistorted element exactly.
    fn points(&self) -> &'static [Point];

    /// Shape functions Nₐ at (ξ, η).
    fn shapes(&self, at: [f64; 2]) -> [f64; MAX_NODES];

    /// Derivatives of the shape functions (∂Nₐ/∂ξ, ∂Nₐ/∂η) at (ξ, η).
    fn slopes(&self, at: [f64; 2]) -> [[f64; 2]; MAX_NODES];

    /// Number of nodes.
    fn nodes(&self) -> usize {
        self.reference().len()
    }

    /// Number of corners (and of sides).
    fn corners(&self) -> usize {
        self.edges().len()
    }
}

/// Every element there is.
pub const ALL: &[&dyn PlaneElement] = &[&Tri3, &Tri6, &Quad4, &Quad8, &Quad9];

impl fmt::Debug for dyn PlaneElement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl PartialEq for dyn PlaneElement {
    fn eq(&self, other: &Self) -> bool {
        self.name() == other.name()
    }
}

/// Sides of a triangle of first and second order.
const TRIANGLE_EDGES: [&[usize]; 3] = [&[0, 1], &[1, 2], &[2, 0]];
const TRIANGLE_EDGES_2: [&[usize]; 3] = [&[0, 1, 3], &[1, 2, 4], &[2, 0, 5]];
/// Sides of a quadrilateral of first and second order.
const SQUARE_EDGES: [&[usize]; 4] = [&[0, 1], &[1, 2], &[2, 3], &[3, 0]];
const SQUARE_EDGES_2: [&[usize]; 4] = [&[0, 1, 4], &[1, 2, 5], &[2, 3, 6], &[3, 0, 7]];
