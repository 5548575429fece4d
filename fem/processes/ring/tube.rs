//! Motion of the cut surface of a ring that jaws press on a part of its width: what they do there fades along it.
//!
//! As of a plane ring, waves of load make waves of motion of the same number, cₘ·cos mθ, but each section has compliances of its own. They
//! are those of the half section ([`Tube`]), found until no section feels them any more. The tube that is solved has Ro = E = 1, so
//! that a force F per radian moves it by F/(E·Ro)·cₘ.

use super::response::{Response, unsolvable};
use crate::element::plane::{Elasticity, Quad8};
use crate::mesh::{BORE, OUTSIDE, RevolvedMesh, Wall};
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

/// Compliances of the cut surface, section by section, of a ring with Ro = E = b = 1 but for its proportions.
#[derive(Clone, Debug)]
pub struct Sections {
    step: usize,
    /// Places of nodes along the ring, over Ro, rising: ends and middles of elements by turns.
    places: Vec<f64>,
    /// Of each harmonic, at each of the places.
    compliances: Vec<Vec<f64>>,
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
        let mut cut = mesh.nodes_on(if is_outside { BORE } else { OUTSIDE }).map_err(unsolvable)?;
        cut.sort_by(|a, b| mesh.nodes()[*a as usize][0].total_cmp(&mesh.nodes()[*b as usize][0]));
        let places = cut.iter().map(|node| mesh.nodes()[*node as usize][0]).collect();
        let law = Elasticity::revolved(1.0, poisson_ratio, 0.0).map_err(unsolvable)?;
        let tube = Tube::new(mesh, &law, &Band { is_outside, reach }).map_err(unsolvable)?;
        let (mut compliances, mut largest) = (Vec::new(), 0.0f64);
        for m in (0..MOST_WAVES).step_by(step) {
            let moved = tube.wave(m).map_err(unsolvable)?;
            // With b = 1 as well, as those of a plane ring are.
            let own: Vec<f64> = cut.iter().map(|node| width * moved[*node as usize]).collect();
            let most = own.iter().fold(0.0f64, |most, c| most.max(c.abs()));
            compliances.push(own);
            largest = largest.max(most);
            if m > 1 && most <= SHIELDED * largest {
                break;
            }
        }
        Ok(Self { step, places, compliances })
    }

    /// The response of the section at a place, over Ro.
    pub fn at(&self, place: f64) -> Response {
        let last = self.places.len() - 1;
        // The element that has it: its ends have even numbers.
        let beyond = self.places.partition_point(|own| *own <= place);
        let first = (beyond.saturating_sub(1) / 2 * 2).min(last - 2);
        let [a, b] = [self.places[first], self.places[first + 2]];
        let s = (2.0 * (place - a) / (b - a) - 1.0).clamp(-1.0, 1.0);
        let weights = [0.5 * s * (s - 1.0), 1.0 - s * s, 0.5 * s * (s + 1.0)];
        let of = |own: &Vec<f64>| weights.iter().zip(&own[first..]).map(|(weight, c)| weight * c).sum();
        Response::new(self.step, self.compliances.iter().map(of).collect())
    }
}
