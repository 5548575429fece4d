//! Triangle of first order: constant gradient.
//!
//! ```text
//!   eta
//!   2
//!   | `.          N0 = 1 − ξ − η
//!   |   `.        N1 = ξ
//!   0-----1 xi    N2 = η
//! ```

use super::quadrature::{Point, TRIANGLE_3};
use super::{MAX_NODES, PlaneElement, TRIANGLE_EDGES};

/// Three nodes. Stiff in bending; for second order prefer [`Tri6`](super::Tri6).
pub struct Tri3;

impl PlaneElement for Tri3 {
    fn name(&self) -> &'static str {
        "tri3"
    }

    fn reference(&self) -> &'static [[f64; 2]] {
        &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]
    }

    fn edges(&self) -> &'static [&'static [usize]] {
        &TRIANGLE_EDGES
    }

    fn points(&self) -> &'static [Point] {
        &TRIANGLE_3
    }

    fn shapes(&self, [xi, eta]: [f64; 2]) -> [f64; MAX_NODES] {
        [1.0 - xi - eta, xi, eta, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    }

    fn slopes(&self, _: [f64; 2]) -> [[f64; 2]; MAX_NODES] {
        let mut slopes = [[0.0; 2]; MAX_NODES];
        slopes[..3].copy_from_slice(&[[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]]);
        slopes
    }
}
