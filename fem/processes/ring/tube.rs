//! Motion of a ring that jaws press on a part of its width: what they do there fades along it.
//!
//! As of a plane ring, waves of load make waves of motion of the same number, but each section has compliances of its own. They
//! are those of the half section ([`Tube`]), found until no section feels them any more. The tube that is solved has Ro = E = 1, so
//! that a force F per radian moves it by F/(E·Ro) as much.

use super::jaws::Jaw;
use super::response::{BoreSeries, Response, unsolvable};
use crate::element::plane::{Elasticity, Quad8};
use crate::mesh::{BORE, Mesh, OUTSIDE, RevolvedMesh, Wall};
use crate::process::Failure;
use crate::solve::ring::{Band, Tube};

/// No section feels a harmonic below this part of the largest.
const SHIELDED: f64 = 1e-8;
/// Most waves around that are looked at: of a wall as thin as this part of the circle.
const MOST_WAVES: usize = 720;
/// Most cells of the half section.
const MOST_CELLS: f64 = 6000.0;
/// Cells across the wall, at most: of thicker walls bores are shielded from what more of them would show.
const ACROSS: usize = 12;

/// A ring as far as its response depends on it; lengths over its outer radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Ri/Ro.
    pub ratio: f64,
    /// b/Ro.
    pub width: f64,
    /// Where the jaws press along it.
    pub reach: [f64; 2],
    /// Whether they press on its outside, or else in its bore.
    pub is_outside: bool,
    /// ν.
    pub poisson_ratio: f64,
    /// Elements across the wall.
    pub radial: usize,
    /// Only multiples of this harmonic occur.
    pub step: usize,
}

/// Compliances of the surfaces of a ring, section by section; it has Ro = E = b = 1 but for its proportions.
#[derive(Clone, Debug)]
pub struct Sections {
    step: usize,
    /// The surface that is cut, and the one that the jaws press on.
    surfaces: [Surface; 2],
}

/// A surface.
#[derive(Clone, Debug)]
struct Surface {
    nodes: Vec<u32>,
    /// Places of nodes along the ring, over Ro, rising: ends and middles of elements by turns.
    places: Vec<f64>,
    /// Of each harmonic, at each of the places: along, outwards, around.
    compliances: Vec<Vec<[f64; 3]>>,
}

impl Sections {
    /// Those of a ring.
    ///
    /// # Errors
    /// Its equations cannot be solved.
    pub fn solve(shape: &Shape) -> Result<Self, Failure> {
        let Shape { ratio, width, reach, is_outside, poisson_ratio, radial, step } = *shape;
        let wall = 1.0 - ratio;
        let size = (wall / radial.min(ACROSS) as f64).max((wall * width / MOST_CELLS).sqrt());
        let walls = vec![Wall { length: width, radii: [ratio, 1.0] }];
        let mesh = RevolvedMesh { walls, size, sections: reach.to_vec(), element: &Quad8 };
        let mesh = mesh.build().map_err(unsolvable)?;
        let [cut, held] = if is_outside { [BORE, OUTSIDE] } else { [OUTSIDE, BORE] };
        let mut surfaces = [Surface::new(&mesh, cut)?, Surface::new(&mesh, held)?];
        let law = Elasticity::revolved(1.0, poisson_ratio, 0.0).map_err(unsolvable)?;
        let tube = Tube::new(mesh, &law, &Band { is_outside, reach }).map_err(unsolvable)?;
        let mut largest = 0.0f64;
        for m in (0..MOST_WAVES).step_by(step) {
            let moved = tube.wave(m).map_err(unsolvable)?;
            for surface in &mut surfaces {
                // With b = 1 as well, as those of a plane ring are.
                let own = surface.nodes.iter().map(|node| moved[*node as usize].map(|c| width * c));
                surface.compliances.push(own.collect());
            }
            let most =
                surfaces[0].compliances.last().into_iter().flatten().fold(0.0f64, |most, c| most.max(c[1].abs()));
            largest = largest.max(most);
            if m > 1 && most <= SHIELDED * largest {
                break;
            }
        }
        Ok(Self { step, surfaces })
    }

    /// The response of a section of the surface that is cut, at a place over Ro.
    pub fn at(&self, place: f64) -> Response {
        let [cut, _] = &self.surfaces;
        let last = cut.places.len() - 1;
        // The element that has it: its ends have even numbers.
        let beyond = cut.places.partition_point(|own| *own <= place);
        let first = (beyond.saturating_sub(1) / 2 * 2).min(last - 2);
        let [a, b] = [cut.places[first], cut.places[first + 2]];
        let s = (2.0 * (place - a) / (b - a) - 1.0).clamp(-1.0, 1.0);
        let weights = [0.5 * s * (s - 1.0), 1.0 - s * s, 0.5 * s * (s + 1.0)];
        let of = |own: &Vec<[f64; 3]>| weights.iter().zip(&own[first..]).map(|(weight, c)| weight * c[1]).sum();
        Response::new(self.step, cut.compliances.iter().map(of).collect())
    }

    /// Places along the ring at which elements begin and end, over Ro; the last is its other face.
    pub fn places(&self) -> Vec<f64> {
        self.surfaces[0].places.iter().step_by(2).copied().collect()
    }

    /// Motions at such a place, by its number, of the surface that is cut or of the one that the jaws press on: along, outwards and
    /// around, per newton of jaw force with E = b = 1.
    pub fn motions(&self, is_cut: bool, place: usize, jaws: &[Jaw]) -> [BoreSeries; 3] {
        let surface = &self.surfaces[usize::from(!is_cut)];
        let response = |component: usize| {
            let own = surface.compliances.iter().map(|own| own[2 * place][component]);
            Response::new(self.step, own.collect())
        };
        let [along, outwards, around] = [0, 1, 2].map(response);
        [along.under(jaws), outwards.under(jaws), around.under(jaws).beside()]
    }
}

impl Surface {
    fn new(mesh: &Mesh, side: &str) -> Result<Self, Failure> {
        let mut nodes = mesh.nodes_on(side).map_err(unsolvable)?;
        let x = |node: u32| mesh.nodes()[node as usize][0];
        nodes.sort_by(|a, b| x(*a).total_cmp(&x(*b)));
        let places = nodes.iter().map(|node| x(*node)).collect();
        Ok(Self { nodes, places, compliances: Vec::new() })
    }
}
