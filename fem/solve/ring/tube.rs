//! A tube pressed by waves around on a part of its length: not plane, for what is pressed at one end is hardly felt at the other.
//!
//! A radial load of cos mθ newtons per radian, spread evenly over the length of a band, moves every place by waves of that number
//! alone, which [the half section](crate::element::plane::Elasticity::wave_stiffness) has. The stiffness of each number is made up of three
//! matrices of one pattern, which is analysed once. A tube that stands still along and around, under m = 0, is held at one node; waves of two and
//! more hold themselves, and loads in equilibrium have none of one.

use std::sync::Arc;

use crate::element::plane::quadrature::LINE_5;
use crate::element::plane::{EDGE_NODES, Elasticity, edge_shapes};
use crate::mesh::{BORE, Mesh, OUTSIDE};
use crate::solve::sparse::{Analysis, Freedoms, Graph, Matrix, Order, Pattern, Solver, SparseError};

/// Components of a node: along, outwards, around.
const COMPONENTS: usize = 3;
const ALONG: usize = 0;
const OUTWARDS: usize = 1;
const AROUND: usize = 2;
/// Part of the length of a tube within which two places are one.
const NEAR: f64 = 1e-9;

/// The part of a surface that is pressed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// Whether it is the outside, or else the bore.
    pub is_outside: bool,
    /// Where it begins and ends along the tube, m; borders of elements.
    pub reach: [f64; 2],
}

/// A tube with its stiffness as far as the number of waves does not change it.
pub struct Tube {
    mesh: Mesh,
    /// For m = 0, and for m ≥ 2.
    parts: [Parts; 2],
    /// Radial load of each node for a newton per radian, inwards, N.
    load: Vec<(u32, f64)>,
}

/// What a stiffness is made up of.
struct Parts {
    freedoms: Freedoms,
    /// Of powers of m.
    powers: [Matrix; 3],
    analysis: Analysis,
}

impl Band {
    /// Name of the surface.
    fn surface(&self) -> &'static str {
        if self.is_outside { OUTSIDE } else { BORE }
    }
}

impl Tube {
    /// A tube of the mesh of a half section, pressed on a band.
    ///
    /// # Errors
    /// No memory, or an element without a stiffness.
    pub fn new(mesh: Mesh, law: &Elasticity, band: &Band) -> Result<Self, SparseError> {
        let graph = Graph::new(&mesh);
        let order = Order::default().find(&graph, mesh.nodes())?;
        let parts = |held: &[usize]| -> Result<Parts, SparseError> {
            let freedoms = Freedoms::new(COMPONENTS, &order, held);
            let pattern = Arc::new(Pattern::new(&graph, &freedoms));
            let power = |power: usize| {
                Matrix::assemble::<COMPONENTS>(&mesh, &pattern, &freedoms, |_, sampled, coordinates, square| {
                    law.wave_stiffness(power, sampled, coordinates, square);
                })
            };
            let powers = [power(0)?, power(1)?, power(2)?];
            let analysis = Analysis::of(&powers[0])?;
            Ok(Parts { freedoms, powers, analysis })
        };
        let parts = [parts(&[ALONG, AROUND])?, parts(&[])?];
        let load = load(&mesh, band);
        Ok(Self { mesh, parts, load })
    }

    /// The mesh of the half section.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// How every node moves (m; along and outwards as cos mθ, around as sin mθ) under a radial load of cos mθ newtons per radian on
    /// the band, inwards. Zero for m = 1.
    ///
    /// # Errors
    /// The stiffness cannot be factored, or its solution has no accuracy.
    pub fn wave(&self, m: usize) -> Result<Vec<[f64; COMPONENTS]>, SparseError> {
        if m == 1 {
            return Ok(vec![[0.0; COMPONENTS]; self.mesh.nodes().len()]);
        }
        let Parts { freedoms, powers: [still, once, twice], analysis } = &self.parts[m.min(1)];
        let waves = m as f64;
        let matrix = still.combined(1.0, once, waves).combined(1.0, twice, waves * waves);
        let solver = Solver::new(analysis, &matrix, freedoms, self.mesh.nodes())?;
        let mut forces = vec![0.0; freedoms.len()];
        for (node, force) in &self.load {
            forces[COMPONENTS * *node as usize + OUTWARDS] -= force;
        }
        let mut moved = vec![0.0; freedoms.len()];
        solver.solve(&matrix, &freedoms.gather(&forces), &mut moved)?;
        let moved = freedoms.scatter(&moved);
        Ok(moved.chunks_exact(COMPONENTS).map(|own| [own[ALONG], own[OUTWARDS], own[AROUND]]).collect())
    }
}

/// What each node of a band bears of a newton per radian that is spread evenly over its length, N.
fn load(mesh: &Mesh, band: &Band) -> Vec<(u32, f64)> {
    let [from, to] = band.reach;
    let near = NEAR * (to - from);
    let mut load = Vec::new();
    for side in mesh.sides(band.surface()).unwrap_or_default() {
        let nodes = mesh.side_nodes(*side);
        let nodes = nodes.as_slice();
        let ends = [nodes[0], nodes[1]].map(|node| mesh.nodes()[node as usize][0]);
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        if low < from - near || high > to + near {
            continue;
        }
        // Sides are straight, their middles in the middle.
        let mut shares = [0.0; EDGE_NODES];
        for (at, weight) in LINE_5 {
            let shapes = edge_shapes(nodes.len(), at);
            shares.iter_mut().zip(shapes).for_each(|(share, shape)| *share += 0.5 * weight * shape);
        }
        let part = (high - low) / (to - from);
        load.extend(nodes.iter().zip(shares).map(|(node, share)| (*node, part * share)));
    }
    load
}

#[cfg(test)]
mod tests {
    use super::super::WaveRing;
    use super::*;
    use crate::element::plane::{PlaneState, Quad8};
    use crate::mesh::{RevolvedMesh, Wall};

    const OUTER: f64 = 0.05;
    const INNER: f64 = 0.042;

    /// A tube of unit stiffness, pressed outside on a band.
    fn tube(length: f64, reach: [f64; 2], poisson_ratio: f64, size: f64) -> Tube {
        let walls = vec![Wall { length, radii: [INNER, OUTER] }];
        let mesh = RevolvedMesh { walls, size, sections: reach.to_vec(), element: &Quad8 }.build().unwrap();
        let law = Elasticity::revolved(1.0, poisson_ratio, 0.0).unwrap();
        Tube::new(mesh, &law, &Band { is_outside: true, reach }).unwrap()
    }

    /// Motion of the bore near x.
    fn bore(tube: &Tube, m: usize, x: f64) -> f64 {
        tube.wave(m).unwrap()[tube.mesh().nearest_node([x, INNER])][OUTWARDS]
    }

    /// Without a Poisson's ratio sections do not hinder each other: each is a plane ring.
    #[test]
    fn pressed_all_along_it_is_a_plane_ring() {
        let width = 0.02;
        let law = Elasticity::new(PlaneState::Stress, 1.0, 0.0, 0.0, width).unwrap();
        let (inner_radius, outer_radius) = (INNER, OUTER);
        let ring =
            WaveRing { outer_radius, inner_radius, circumferential: 720, radial: 6, element: &Quad8, law }.cell();
        let size = 0.0013;
        let tube = tube(width, [0.0, width], 0.0, size);
        for m in [0, 2, 3, 6, 15] {
            let (own, plane) = (bore(&tube, m, 0.01), ring.compliance(m).unwrap());
            // Of elements of second order the energy is good to the fourth power of half an element beside a wave.
            let allowed = 1e-5 + (0.5 * size * m as f64 / INNER).powi(4);
            assert!((own / plane - 1.0).abs() < allowed, "{m}: {own} {plane}");
        }
    }

    /// Lamé's tube under an even pressure, at any Poisson's ratio: the ends are free.
    #[test]
    fn under_an_even_pressure_it_is_lames() {
        let (width, ratio) = (0.03, 0.3);
        let tube = tube(width, [0.0, width], ratio, 0.001);
        // A newton per radian on all of the length is a pressure of 1/(Ro·b).
        let pressure = 1.0 / (OUTER * width);
        let expected = -2.0 * pressure * OUTER * OUTER * INNER / (OUTER * OUTER - INNER * INNER);
        for x in [0.0, 0.01, 0.03] {
            assert!((bore(&tube, 0, x) / expected - 1.0).abs() < 1e-6, "{x}");
        }
    }

    /// A long thin tube under a line load around: a beam on an elastic foundation, w = P·β/(2k) there, P per length of the circle.
    #[test]
    fn a_line_around_a_thin_tube_bends_it_as_a_beam_on_its_foundation() {
        let (inner, outer, nu, length) = (0.0495, 0.05, 0.3, 0.06);
        let walls = vec![Wall { length, radii: [inner, outer] }];
        let reach = [0.0298, 0.0302];
        let mesh = RevolvedMesh { walls, size: 0.000_25, sections: reach.to_vec(), element: &Quad8 }.build().unwrap();
        let law = Elasticity::revolved(1.0, nu, 0.0).unwrap();
        let tube = Tube::new(mesh, &law, &Band { is_outside: true, reach }).unwrap();
        let (a, t) = (0.5 * (inner + outer), outer - inner);
        let beta = (3.0 * (1.0 - nu * nu) / (a * a * t * t)).powf(0.25);
        // One newton per radian is 1/a per length; the foundation is E·t/a².
        let expected = -(1.0 / a) * beta * a * a / (2.0 * t);
        let own = tube.wave(0).unwrap()[tube.mesh().nearest_node([0.03, inner])][OUTWARDS];
        // Thin to t/a = 1 %, and the load is not quite a line: β·0.4 mm = 0.1.
        assert!((own / expected - 1.0).abs() < 0.03, "{own} {expected}");
    }

    /// What the outside moves by under a load of the bore is what the bore moves by under the same load outside.
    #[test]
    fn loads_move_each_other_alike() {
        let walls = vec![Wall { length: 0.06, radii: [INNER, OUTER] }];
        let (near, far) = ([0.0, 0.01], [0.045, 0.05]);
        let sections = [near, far].concat();
        let mesh = || {
            RevolvedMesh { walls: walls.clone(), size: 0.002, sections: sections.clone(), element: &Quad8 }
                .build()
                .unwrap()
        };
        let law = Elasticity::revolved(1.0, 0.3, 0.0).unwrap();
        let [outside, inside] = [(true, near), (false, far)]
            .map(|(is_outside, reach)| Tube::new(mesh(), &law, &Band { is_outside, reach }).unwrap());
        for m in [0, 2, 3, 9] {
            let work = |moved: &[[f64; COMPONENTS]], load: &[(u32, f64)]| -> f64 {
                load.iter().map(|(node, force)| moved[*node as usize][OUTWARDS] * force).sum()
            };
            let (one, other) =
                (work(&outside.wave(m).unwrap(), &inside.load), work(&inside.wave(m).unwrap(), &outside.load));
            assert!((one / other - 1.0).abs() < 1e-8 || one.abs() < 1e-12, "{m}: {one} {other}");
        }
    }
}
