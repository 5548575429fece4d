//! Serendipity quadrilateral of second order.
//!
//! ```text
//!          eta
//!     3-----6-----2
//!     |     |     |      corners          Na = (1 + ξ ξa)(1 + η ηa)(ξ ξa + η ηa − 1)/4
//!     7     +-----5-- xi middles, ξa = 0  Na = (1 − ξ²)(1 + η ηa)/2
//!     |           |      middles, ηa = 0  Na = (1 + ξ ξa)(1 − η²)/2
//!     0-----4-----1
//! ```

use super::quadrature::{Point, SQUARE_9};
use super::{MAX_NODES, PlaneElement, SQUARE_EDGES_2};

/// Eight nodes: the element for rings. Full quadrature (3 × 3), so that it has no modes without energy.
pub struct Quad8;

const NODES: [[f64; 2]; 8] =
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];

impl PlaneElement for Quad8 {
    fn name(&self) -> &'static str {
        "quad8"
    }

    fn reference(&self) -> &'static [[f64; 2]] {
        &NODES
    }

    fn edges(&self) -> &'static [&'static [usize]] {
        &SQUARE_EDGES_2
    }

    fn points(&self) -> &'static [Point] {
        &SQUARE_9
    }

    fn shapes(&self, [xi, eta]: [f64; 2]) -> [f64; MAX_NODES] {
        let mut shapes = [0.0; MAX_NODES];
        for (shape, [x, y]) in shapes.iter_mut().zip(NODES) {
            let (right, up) = (1.0 + xi * x, 1.0 + eta * y);
            *shape = if x == 0.0 {
                0.5 * (1.0 - xi * xi) * up
            } else if y == 0.0 {
                0.5 * right * (1.0 - eta * eta)
            } else {
                0.25 * right * up * (xi * x + eta * y - 1.0)
            };
        }
        shapes
    }

    fn slopes(&self, [xi, eta]: [f64; 2]) -> [[f64; 2]; MAX_NODES] {
        let mut slopes = [[0.0; 2]; MAX_NODES];
        for (slope, [x, y]) in slopes.iter_mut().zip(NODES) {
            let (right, up) = (1.0 + xi * x, 1.0 + eta * y);
            *slope = if x == 0.0 {
                [-xi * up, 0.5 * (1.0 - xi * xi) * y]
            } else if y == 0.0 {
                [0.5 * x * (1.0 - eta * eta), -eta * right]
            } else {
                [0.25 * x * up * (2.0 * xi * x + eta * y), 0.25 * y * right * (xi * x + 2.0 * eta * y)]
            };
        }
        slopes
    }
}
