//! Triangle of second order.
//!
//! ```text
//!   eta
//!   2
//!   | `.            L = (1 − ξ − η, ξ, η)
//!   5   `4          corners      Ni = Li (2 Li − 1)
//!   |     `.        middles      N3 = 4 L0 L1, N4 = 4 L1 L2, N5 = 4 L2 L0
//!   0---3---1 xi
//! ```

use super::quadrature::{Point, TRIANGLE_6};
use super::{MAX_NODES, PlaneElement, TRIANGLE_EDGES_2};

/// Six nodes: complete quadratics.
pub struct Tri6;

/// ∂L/∂(ξ, η) of the three area coordinates.
const SLOPES: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

impl PlaneElement for Tri6 {
    fn name(&self) -> &'static str {
        "tri6"
    }

    fn reference(&self) -> &'static [[f64; 2]] {
        &[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.0], [0.5, 0.5], [0.0, 0.5]]
    }

    fn edges(&self) -> &'static [&'static [usize]] {
        &TRIANGLE_EDGES_2
    }

    fn points(&self) -> &'static [Point] {
        &TRIANGLE_6
    }

    fn shapes(&self, [xi, eta]: [f64; 2]) -> [f64; MAX_NODES] {
        let area = [1.0 - xi - eta, xi, eta];
        let mut shapes = [0.0; MAX_NODES];
        for side in 0..3 {
            let (here, next) = (area[side], area[(side + 1) % 3]);
            shapes[side] = here * (2.0 * here - 1.0);
            shapes[3 + side] = 4.0 * here * next;
        }
        shapes
    }

    fn slopes(&self, [xi, eta]: [f64; 2]) -> [[f64; 2]; MAX_NODES] {
        let area = [1.0 - xi - eta, xi, eta];
        let mut slopes = [[0.0; 2]; MAX_NODES];
        for side in 0..3 {
            let next = (side + 1) % 3;
            for axis in 0..2 {
                slopes[side][axis] = (4.0 * area[side] - 1.0) * SLOPES[side][axis];
                slopes[3 + side][axis] = 4.0 * (area[next] * SLOPES[side][axis] + area[side] * SLOPES[next][axis]);
            }
        }
        slopes
    }
}
