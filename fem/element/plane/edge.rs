//! Sides of elements: the curve x(s) = Σ Nₐ(s) xₐ, s from −1 at the start to 1 at the end, and integrals
//! along it.
//!
//! ```text
//!   0-------2-------1     second order: N0 = s (s − 1)/2, N1 = s (s + 1)/2, N2 = 1 − s²
//!   0---------------1     first order:  N0 = (1 − s)/2,   N1 = (1 + s)/2
//!  s=-1            s=1    the body lies to the left
//! ```
//!
//! The shape functions of every element reduce to these along its sides (a property test checks that they
//! do).

use super::Thickness;
use super::quadrature::LINE_3;

/// The most nodes a side has; arrays over its nodes have this length.
pub const EDGE_NODES: usize = 3;

/// All of a side, in s.
pub const WHOLE: [f64; 2] = [-1.0, 1.0];

/// Shape functions of a side of `nodes` (2 or 3) nodes: start, end, middle.
pub fn edge_shapes(nodes: usize, s: f64) -> [f64; EDGE_NODES] {
    if nodes == 2 {
        [0.5 * (1.0 - s), 0.5 * (1.0 + s), 0.0]
    } else {
        [0.5 * s * (s - 1.0), 0.5 * s * (s + 1.0), 1.0 - s * s]
    }
}

/// Derivatives of the shape functions of a side by s.
pub fn edge_slopes(nodes: usize, s: f64) -> [f64; EDGE_NODES] {
    if nodes == 2 { [-0.5, 0.5, 0.0] } else { [s - 0.5, s + 0.5, -2.0 * s] }
}

/// The curve of one side.
#[derive(Clone, Copy, Debug)]
pub struct EdgeCurve {
    nodes: usize,
    coordinates: [[f64; 2]; EDGE_NODES],
}

impl EdgeCurve {
    /// The side through `coordinates` (m): start, end and, in second order, the middle.
    pub fn new(coordinates: &[[f64; 2]]) -> Self {
        let mut own = [[0.0; 2]; EDGE_NODES];
        own[..coordinates.len()].copy_from_slice(coordinates);
        Self { nodes: coordinates.len(), coordinates: own }
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    fn combine(&self, weights: [f64; EDGE_NODES]) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for (weight, node) in weights.into_iter().zip(self.coordinates) {
            sum = [sum[0] + weight * node[0], sum[1] + weight * node[1]];
        }
        sum
    }

    /// Point x(s), m.
    pub fn point(&self, s: f64) -> [f64; 2] {
        self.combine(edge_shapes(self.nodes, s))
    }

    /// Tangent dx/ds, m.
    pub fn tangent(&self, s: f64) -> [f64; 2] {
        self.combine(edge_slopes(self.nodes, s))
    }

    /// ∫ f dl from `from` to `to` (in s), where `add(dl, N, n dl)` adds f up at each quadrature point: length
    /// element (m), shape functions, outward normal times the length element (m).
    pub fn integrate_over(&self, from: f64, to: f64, mut add: impl FnMut(f64, &[f64; EDGE_NODES], [f64; 2])) {
        let half = 0.5 * (to - from);
        for (place, weight) in LINE_3 {
            let s = 0.5 * (from + to) + half * place;
            let [x, y] = self.tangent(s);
            let scale = half * weight;
            add(x.hypot(y) * scale, &edge_shapes(self.nodes, s), [y * scale, -x * scale]);
        }
    }

    /// Length, m.
    pub fn length(&self) -> f64 {
        let mut length = 0.0;
        self.integrate_over(WHOLE[0], WHOLE[1], |dl, _, _| length += dl);
        length
    }

    /// ∫ f w dl in the same way, w the weight of the thickness.
    fn integrate_weighted(
        &self,
        thickness: Thickness,
        [from, to]: [f64; 2],
        mut add: impl FnMut(f64, &[f64; EDGE_NODES], [f64; 2]),
    ) {
        self.integrate_over(from, to, |dl, shapes, [nx, ny]| {
            let y: f64 = shapes.iter().zip(&self.coordinates).map(|(shape, node)| shape * node[1]).sum();
            let weight = thickness.weight(y);
            add(dl * weight, shapes, [nx * weight, ny * weight]);
        });
    }

    /// ∫ Nₐ w dl (m; of a body of revolution m²) over a part of the side (in s): what a uniform flux or traction gives to
    /// each node.
    pub fn shape_integrals(&self, thickness: Thickness, part: [f64; 2]) -> [f64; EDGE_NODES] {
        let mut integrals = [0.0; EDGE_NODES];
        self.integrate_weighted(thickness, part, |own, shapes, _| {
            for (integral, shape) in integrals.iter_mut().zip(shapes) {
                *integral += shape * own;
            }
        });
        integrals
    }

    /// ∫ Nₐ N_b w dl (m; of a body of revolution m²): times the scale of the thickness and the film coefficient, the
    /// convection matrix.
    pub fn shape_products(&self, thickness: Thickness) -> [[f64; EDGE_NODES]; EDGE_NODES] {
        let mut products = [[0.0; EDGE_NODES]; EDGE_NODES];
        self.integrate_weighted(thickness, WHOLE, |own, shapes, _| {
            for a in 0..EDGE_NODES {
                for b in 0..EDGE_NODES {
                    products[a][b] += shapes[a] * shapes[b] * own;
                }
            }
        });
        products
    }

    /// −∫ Nₐ n w dl (m; of a body of revolution m²): forces per unit of pressure and of the scale of the thickness,
    /// pressing on the body.
    pub fn pressure_forces(&self, thickness: Thickness) -> [[f64; 2]; EDGE_NODES] {
        let mut forces = [[0.0; 2]; EDGE_NODES];
        self.integrate_weighted(thickness, WHOLE, |_, shapes, [nx, ny]| {
            for (force, shape) in forces.iter_mut().zip(shapes) {
                *force = [force[0] - shape * nx, force[1] - shape * ny];
            }
        });
        forces
    }
}
