//! The effect of a wave of radial load around a ring of equal cells on its bore, from a single cell.
//!
//! The structured mesh is the same after a turn by one cell, and stays the same when it is turned over. Under
//! a radial load of cos mθ newtons per radian on the outside every node therefore moves by u_r = a·cos mθ,
//! u_t = b·sin mθ with a, b alike for all nodes of one radius and place in the cell: of the many thousand
//! unknowns those of one cell's nodes are left. With K' the stiffness of an element between polar components,
//! α and β the angles of its nodes, the mean over all N cells is
//!
//! ```text
//!   rr, tt: ½ cos m(α − β) K'      rt: ½ sin m(β − α) K'      tr: ½ sin m(α − β) K'      0 < m < N/2
//! ```
//!
//! a banded system that is solved in microseconds and has the very solution of the whole mesh. For m = 0 the
//! factor is 1 and only u_r counts; m = 1 is a rigid shift, which loads in equilibrium do not ask for.

use std::f64::consts::{PI, TAU};

use crate::element::plane::quadrature::LINE_5;
use crate::element::plane::{EDGE_NODES, EdgeCurve, Elasticity, MAX_NODES, PlaneElement, Sampled, Square, edge_shapes};

/// A ring of equal cells, about the origin.
#[derive(Clone, Copy, Debug)]
pub struct WaveRing {
    /// Outer radius Ro, m.
    pub outer_radius: f64,
    /// Inner radius Ri, m.
    pub inner_radius: f64,
    /// Cells around.
    pub circumferential: usize,
    /// Cells across.
    pub radial: usize,
    /// A quadrilateral of first or second order without a node in its middle.
    pub element: &'static dyn PlaneElement,
    /// Elastic law of the ring.
    pub law: Elasticity,
}

/// One cell of a ring: its elements from the bore outwards.
#[derive(Clone, Debug)]
pub struct Cell {
    ring: WaveRing,
    /// Stiffness between polar components, N/m.
    stiffnesses: Vec<Square<2>>,
    /// Angle (rad) and number of the nodes of each element.
    nodes: Vec<Vec<(f64, usize)>>,
    /// Nodes that differ in radius or in their place in the cell.
    count: usize,
    /// Unknowns that an element couples, less one.
    band: usize,
}

impl WaveRing {
    /// Integrates the elements of one cell.
    pub fn cell(self) -> Cell {
        let sampled = Sampled::new(self.element);
        let second_order = self.element.nodes() > self.element.corners();
        // Nodes by half steps: those on the sides between cells, and, where a circle has them, in the middle.
        let own = |half: usize| -> usize {
            match (second_order, half % 2) {
                (false, _) => half / 2,
                (true, 0) => half / 2 * 3,
                (true, _) => half / 2 * 3 + 2,
            }
        };
        let (mut stiffnesses, mut nodes) = (Vec::new(), Vec::new());
        for layer in 0..self.radial {
            let places: Vec<(usize, usize)> = self
                .element
                .reference()
                .iter()
                .map(|[xi, eta]| (2 * layer + (1.0 + xi).round() as usize, (1.0 + eta).round() as usize))
                .collect();
            let angle = |half: usize| 0.5 * half as f64 * self.angle();
            let coordinates: Vec<[f64; 2]> = places
                .iter()
                .map(|(out, around)| {
                    let (sine, cosine) = angle(*around).sin_cos();
                    [self.radius(*out) * cosine, self.radius(*out) * sine]
                })
                .collect();
            let mut square = [[[[0.0; 2]; 2]; MAX_NODES]; MAX_NODES];
            self.law.stiffness(&sampled, &coordinates, &mut square);
            let angles: Vec<f64> = places.iter().map(|place| angle(place.1)).collect();
            stiffnesses.push(polar(&square, &angles));
            nodes.push(angles.into_iter().zip(&places).map(|(a, (out, around))| (a, own(*out) + around % 2)).collect());
        }
        let spread = |nodes: &Vec<(f64, usize)>| {
            let (low, high) = nodes.iter().fold((usize::MAX, 0), |(l, h), n| (l.min(n.1), h.max(n.1)));
            2 * (high - low) + 1
        };
        let band = nodes.iter().map(spread).max().unwrap_or(0);
        let count = own(2 * self.radial) + if second_order { 2 } else { 1 };
        Cell { ring: self, stiffnesses, nodes, count, band }
    }

    /// Angle of one cell, rad.
    fn angle(&self) -> f64 {
        TAU / self.circumferential as f64
    }

    /// Radius at `half` half cells from the bore, m.
    fn radius(&self, half: usize) -> f64 {
        let part = half as f64 / (2 * self.radial) as f64;
        self.inner_radius * (1.0 - part) + self.outer_radius * part
    }
}

/// A stiffness between Cartesian components turned to polar ones at each node: R(α)ᵀ K R(β).
fn polar(square: &Square<2>, angles: &[f64]) -> Square<2> {
    let mut turned = [[[[0.0; 2]; 2]; MAX_NODES]; MAX_NODES];
    let axes = |angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        [[cosine, sine], [-sine, cosine]]
    };
    for (a, alpha) in angles.iter().enumerate() {
        for (b, beta) in angles.iter().enumerate() {
            for (i, left) in axes(*alpha).into_iter().enumerate() {
                for (j, right) in axes(*beta).into_iter().enumerate() {
                    let k = square[a][b];
                    turned[a][b][i][j] =
                        (0..2).map(|x| (0..2).map(|y| left[x] * k[x][y] * right[y]).sum::<f64>()).sum();
                }
            }
        }
    }
    turned
}

impl Cell {
    /// cₘ (m/N rad): the bore moves by u_r = cₘ·cos mθ under a radial load of cos mθ newtons per radian,
    /// inwards, on the outside. Zero for m = 1; `None` for waves shorter than two cells, and where rounding
    /// leaves the ring no stiffness.
    pub fn compliance(&self, m: usize) -> Option<f64> {
        self.between(m, 2 * self.ring.radial, 0)
    }

    /// The same of the pressed surface itself, the outside or the bore, as it gives way to the load.
    pub fn own_compliance(&self, m: usize, is_outside: bool) -> Option<f64> {
        let half = if is_outside { 2 * self.ring.radial } else { 0 };
        Some(-self.between(m, half, half)?)
    }

    /// Motion of the circle at `seen` half cells from the bore under a load inwards on that at `pressed`, m/N rad.
    fn between(&self, m: usize, pressed: usize, seen: usize) -> Option<f64> {
        if m == 1 {
            return Some(0.0);
        }
        if 2 * m >= self.ring.circumferential {
            return None;
        }
        let mut matrix = self.matrix(m);
        let (pressed, seen) = (self.edge(m, pressed), self.edge(m, seen));
        let mut motion = vec![0.0; 2 * self.count];
        pressed.iter().for_each(|(unknown, value)| motion[*unknown] -= value);
        matrix.solve(&mut motion)?;
        let around = self.ring.circumferential as f64 / if m == 0 { TAU } else { PI };
        Some(around * seen.iter().map(|(unknown, value)| value * motion[*unknown]).sum::<f64>())
    }

    /// Mean over the cells of products of two waves.
    fn mean(m: usize) -> f64 {
        if m == 0 { 1.0 } else { 0.5 }
    }

    fn matrix(&self, m: usize) -> Banded {
        let mut matrix = Banded::zero(2 * self.count, self.band);
        let wave = m as f64;
        for (square, nodes) in self.stiffnesses.iter().zip(&self.nodes) {
            for (a, (alpha, row)) in nodes.iter().enumerate() {
                for (b, (beta, column)) in nodes.iter().enumerate() {
                    let (sine, cosine) = (wave * (beta - alpha)).sin_cos();
                    let [[rr, rt], [tr, tt]] = square[a][b];
                    let (r, t) = (2 * row, 2 * row + 1);
                    let mean = Self::mean(m);
                    matrix.add(r, 2 * column, mean * cosine * rr);
                    matrix.add(r, 2 * column + 1, mean * sine * rt);
                    matrix.add(t, 2 * column, -mean * sine * tr);
                    // An even load turns nothing, and a turn would meet no resistance.
                    matrix.add(
                        t,
                        2 * column + 1,
                        if m > 0 { mean * cosine * tt } else { f64::from(t == 2 * column + 1) },
                    );
                }
            }
        }
        matrix
    }

    /// ∫ u_r cos mθ dθ over a circle, mean over the cells, as coefficients of the unknowns.
    fn edge(&self, m: usize, half: usize) -> Vec<(usize, f64)> {
        let layer = if half == 0 { 0 } else { self.ring.radial - 1 };
        let side = if half == 0 { -1.0 } else { 1.0 };
        // The order of the shapes along a side: start, end, middle.
        let order = |eta: f64| if eta == 0.0 { 2 } else { usize::from(eta > 0.0) };
        let reference = self.ring.element.reference().iter().zip(&self.nodes[layer]);
        let mut nodes = [(0.0, 0); EDGE_NODES];
        let mut count = 0;
        for ([_, eta], node) in reference.filter(|([xi, _], _)| *xi == side) {
            nodes[order(*eta)] = *node;
            count += 1;
        }
        let nodes = &nodes[..count];
        let radius = self.ring.radius(half);
        let places: Vec<[f64; 2]> =
            nodes.iter().map(|(angle, _)| [radius * angle.cos(), radius * angle.sin()]).collect();
        let curve = EdgeCurve::new(&places);
        let (wave, mean) = (m as f64, Self::mean(m));
        let mut edge: Vec<(usize, f64)> = nodes.iter().flat_map(|(_, n)| [(2 * n, 0.0), (2 * n + 1, 0.0)]).collect();
        for (s, weight) in LINE_5 {
            let ([x, y], [dx, dy]) = (curve.point(s), curve.tangent(s));
            let (theta, turned) = (y.atan2(x), (x * dy - y * dx) / (x * x + y * y));
            for ((a, (angle, _)), shape) in nodes.iter().enumerate().zip(edge_shapes(count, s)) {
                let beyond = theta - angle;
                let part = mean * weight * turned * shape;
                edge[2 * a].1 += part * (wave * beyond).cos() * beyond.cos();
                edge[2 * a + 1].1 -= part * (wave * beyond).sin() * beyond.sin();
            }
        }
        edge
    }
}

/// The lower half of a symmetric matrix with few diagonals, row by row.
struct Banded {
    band: usize,
    rows: Vec<f64>,
}

impl Banded {
    fn zero(size: usize, band: usize) -> Self {
        Self { band, rows: vec![0.0; size * (band + 1)] }
    }

    fn place(&self, row: usize, column: usize) -> usize {
        row * (self.band + 1) + self.band + column - row
    }

    /// Adds below the diagonal and on it; the upper half is the same.
    fn add(&mut self, row: usize, column: usize, value: f64) {
        if column <= row {
            let place = self.place(row, column);
            self.rows[place] += value;
        }
    }

    /// Cholesky in place, and the solution; `None` where a pivot is not above zero.
    fn solve(&mut self, x: &mut [f64]) -> Option<()> {
        for i in 0..x.len() {
            let first = i.saturating_sub(self.band);
            for j in first..=i {
                let from = first.max(j.saturating_sub(self.band));
                let known: f64 = (from..j).map(|k| self.rows[self.place(i, k)] * self.rows[self.place(j, k)]).sum();
                let (own, pivot) = (self.place(i, j), self.place(j, j));
                let left = self.rows[own] - known;
                if i == j && (left.is_nan() || left <= 0.0) {
                    return None;
                }
                self.rows[own] = if i == j { left.sqrt() } else { left / self.rows[pivot] };
            }
        }
        for i in 0..x.len() {
            let known: f64 = (i.saturating_sub(self.band)..i).map(|k| self.rows[self.place(i, k)] * x[k]).sum();
            x[i] = (x[i] - known) / self.rows[self.place(i, i)];
        }
        for i in (0..x.len()).rev() {
            x[i] /= self.rows[self.place(i, i)];
            for k in i.saturating_sub(self.band)..i {
                x[k] -= self.rows[self.place(i, k)] * x[i];
            }
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::Bore;
    use super::super::jaws::add_radial;
    use super::*;
    use crate::element::plane::{PlaneState, Quad4, Quad8};
    use crate::mesh::{Grading, RingMesh};
    use crate::solve::elastic::{ElasticSystem, Loads};

    /// One cell gives what the whole mesh gives, to round-off, for elements of either order, odd numbers of
    /// cells and waves up to the shortest.
    #[test]
    fn one_cell_gives_what_the_whole_mesh_gives() {
        let law = Elasticity::new(PlaneState::Stress, 210e9, 0.3, 0.0, 0.02).unwrap();
        for (element, around, across) in
            [(&Quad8 as &'static dyn PlaneElement, 37, 3), (&Quad8, 24, 1), (&Quad4, 40, 4)]
        {
            let (outer_radius, inner_radius) = (0.05, 0.041);
            let ring = WaveRing { outer_radius, inner_radius, circumferential: around, radial: across, element, law };
            let cell = ring.cell();
            let grading = Grading::uniform();
            let mesh =
                RingMesh { outer_radius, inner_radius, circumferential: around, radial: across, element, grading };
            let mesh = mesh.build().unwrap();
            let system = ElasticSystem::free(&mesh, law).unwrap();
            let bore = Bore::new(&mesh).unwrap();
            for m in (0..around.div_ceil(2)).filter(|m| *m != 1) {
                let mut loads = Loads::none(&mesh);
                add_radial(&mut loads, &mesh, |angle| (m as f64 * angle).cos()).unwrap();
                let shape = bore.shape(&system.solve(&loads).unwrap().nodes);
                let expected = if m == 0 { shape.mean() } else { shape.harmonic(m as u32).0 };
                let found = cell.compliance(m).unwrap();
                let scale = cell.compliance(2).unwrap().abs();
                assert!(
                    (found - expected).abs() < 1e-9 * (scale.min(1e3 * expected.abs())),
                    "{element:?} {m}: {found} {expected}"
                );
            }
            assert_eq!((cell.compliance(1), cell.compliance(around)), (Some(0.0), None));
        }
    }
}
