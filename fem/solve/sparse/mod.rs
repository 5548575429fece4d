//! Large symmetric positive definite systems from meshes: order, assemble, factor, solve, check.
//!
//! Nodes are ordered once from the mesh ([`Order`]); all freedoms are then numbered so that the free ones
//! stand in elimination order and the held ones last ([`Freedoms`]). The matrix over all freedoms is
//! assembled straight into the compressed columns of its lower triangle ([`Matrix`]); its leading part, over
//! the free ones, is what [`Factor`] factors, without a copy, and the rest gives loads of prescribed values
//! and reactions.

mod assembly;
mod cholesky;
mod dissection;
mod error;
mod freedoms;
mod graph;
mod matrix;
mod numeric;
mod order;
mod pattern;
mod solution;
#[cfg(test)]
mod tests;
mod triangles;

pub use cholesky::{Analysis, Factor};
pub use error::SparseError;
pub use freedoms::Freedoms;
pub use graph::Graph;
pub use matrix::Matrix;
pub use order::Order;
pub use pattern::Pattern;
pub use solution::{Accuracy, Solver};
