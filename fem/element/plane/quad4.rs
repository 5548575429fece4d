//! Quadrilateral of first order.
//!
//! ```text
//!          eta
//!     3-----|-----2
//!     |     |     |      Na = (1 + ξ ξa)(1 + η ηa)/4
//!     |     +-----|-- xi
//!     |           |
//!     0-----------1
//! ```

use super::quadrature::{Point, SQUARE_4};
use super::{MAX_NODES, PlaneElement, SQUARE_EDGES};

/// Four nodes, bilinear. Stiff in bending: meant for heat, and to compare.
pub struct Quad4;

const NODES: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

impl PlaneElement for Quad4 {
    fn name(&self) -> &'static str {
        "quad4"
    }

    fn reference(&self) -> &'static [[f64; 2]] {
        &NODES
    }

    fn edges(&self) -> &'static [&'static [usize]] {
        &SQUARE_EDGES
    }

    fn points(&self) -> &'static [Point] {
        &SQUARE_4
    }

    fn shapes(&self, [xi, eta]: [f64; 2]) -> [f64; MAX_NODES] {
        let mut shapes = [0.0; MAX_NODES];
        for (shape, [x, y]) in shapes.iter_mut().zip(NODES) {
            *shape = 0.25 * (1.0 + xi * x) * (1.0 + eta * y);
        }
        shapes
    }

    fn slopes(&self, [xi, eta]: [f64; 2]) -> [[f64; 2]; MAX_NODES] {
        let mut slopes = [[0.0; 2]; MAX_NODES];
        for (slope, [x, y]) in slopes.iter_mut().zip(NODES) {
            *slope = [0.25 * x * (1.0 + eta * y), 0.25 * (1.0 + xi * x) * y];
        }
        slopes
    }
}
