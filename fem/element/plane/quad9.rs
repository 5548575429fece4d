//! Lagrange quadrilateral of second order.
//!
//! ```text
//!          eta
//!     3-----6-----2
//!     |     |     |      Na = l(ξ, ξa) l(η, ηa),
//!     7     8-----5-- xi l(s, ±1) = s (s ± 1)/2, l(s, 0) = 1 − s²
//!     |           |
//!     0-----4-----1
//! ```

use super::quadrature::{Point, SQUARE_9};
use super::{MAX_NODES, PlaneElement, SQUARE_EDGES_2};

/// Nine nodes, biquadratic: keeps its order on distorted meshes, where [`Quad8`](super::Quad8) loses some.
pub struct Quad9;

const NODES: [[f64; 2]; 9] =
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, 0.0]];

/// l(s, at) and its derivative.
fn lagrange(s: f64, at: f64) -> (f64, f64) {
    if at == 0.0 { (1.0 - s * s, -2.0 * s) } else { (0.5 * s * (s + at), s + 0.5 * at) }
}

impl PlaneElement for Quad9 {
    fn name(&self) -> &'static str {
        "quad9"
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
        NODES.map(|[x, y]| lagrange(xi, x).0 * lagrange(eta, y).0)
    }

    fn slopes(&self, [xi, eta]: [f64; 2]) -> [[f64; 2]; MAX_NODES] {
        NODES.map(|[x, y]| {
            let ((along, along_slope), (up, up_slope)) = (lagrange(xi, x), lagrange(eta, y));
            [along_slope * up, along * up_slope]
        })
    }
}
