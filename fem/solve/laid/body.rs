//! A plane body as far as vertical forces on its underside and its top move these faces.
//!
//! The body is pinned at both ends of its underside, and every node of both faces pushed once by a force of one. What balances
//! leaves nothing to the pins, so that the sums of these solutions are those of the free body but for a rigid motion, and G is
//! symmetric. Forces are spread over their spots as the elements' shapes have it, and the mean over a spot is read with the same
//! weights: what a force does is then work-conjugate to how far it sinks. The body of E = b = 1 is kept, for both divide all motion.

use std::collections::HashMap;
use std::sync::Arc;

use nalgebra::DMatrix;
use rayon::prelude::*;

use super::faces::{Faces, Level, LevelSide};
use super::{Face, Spot, Way};
use crate::element::plane::{Elasticity, STRAINS};
use crate::mesh::Mesh;
use crate::solve::elastic::{ElasticError, ElasticSystem, Loads, Prescribed, nodal_stresses};

/// Places that differ by less than this part of the length are one.
const SAME: f64 = 1e-9;

/// A plane body, solved for every force on its faces.
#[derive(Clone, Debug)]
pub struct Body {
    unit: Arc<Unit>,
    /// E, Pa.
    youngs_modulus: f64,
    /// b, m.
    width: f64,
}

/// Equal are those of the same solution.
impl PartialEq for Body {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.unit, &other.unit) && self.youngs_modulus == other.youngs_modulus && self.width == other.width
    }
}

/// The body with E = b = 1.
#[derive(Debug)]
pub struct Unit {
    system: ElasticSystem<Arc<Mesh>>,
    underside: Vec<Stretch>,
    top: Vec<Stretch>,
    /// The node of the mesh and the direction behind each number.
    motions: Vec<(usize, Way)>,
    /// Motion i under a force on motion j. (motions, motions)
    influence: DMatrix<f64>,
    slack: f64,
}

/// Sides beside each other on one height.
#[derive(Debug)]
struct Stretch {
    height: f64,
    sides: Vec<Side>,
}

/// A straight side of second order along x.
#[derive(Debug)]
struct Side {
    from: f64,
    to: f64,
    /// Numbers of its nodes' motions down: begin, middle, end.
    down: [usize; 3],
    /// Those along the part; none of the top, along which nothing pulls.
    along: Option<[usize; 3]>,
}

/// Motions with their weights, whose sum is one.
type Weights = Vec<(usize, f64)>;

impl Unit {
    /// Of a mesh with these faces, the underside on one height. `law` is that of E = b = 1.
    ///
    /// # Errors
    /// Its equations cannot be solved.
    pub fn new(mesh: Arc<Mesh>, faces: &Faces, law: Elasticity) -> Result<Self, ElasticError> {
        let mut motions = Motions::default();
        let length = mesh.nodes().iter().fold(0.0, |length: f64, node| length.max(node[0]));
        let slack = SAME * length;
        let underside = motions.of_face(&faces.underside, true);
        let top = motions.of_face(&faces.top, false);
        let motions = motions.all;
        let ends = ends(&underside).map(|own| motions[own].0);
        let held = [(ends[0], 0), (ends[0], 1), (ends[1], 1)];
        let held = held.map(|(node, axis)| Prescribed { node, axis, displacement: 0.0 });
        let system = ElasticSystem::held(mesh, law, &held)?;
        let column = |(node, way): &(usize, Way)| -> Result<Vec<f64>, ElasticError> {
            let mut loads = Loads::none(system.mesh());
            loads.add_force(*node, way.direction());
            let moved = system.solve(&loads)?.nodes;
            Ok(motions.iter().map(|(node, way)| way.of(moved[*node])).collect())
        };
        let columns: Vec<f64> = motions.par_iter().map(column).collect::<Result<Vec<_>, _>>()?.concat();
        let influence = DMatrix::from_vec(motions.len(), motions.len(), columns);
        Ok(Self { system, underside, top, motions, influence, slack })
    }

    /// Weights of the motions of a spot, of the higher side where two of a face begin at its middle.
    fn weights(&self, spot: &Spot) -> Weights {
        let face = if spot.face == Face::Underside { &self.underside } else { &self.top };
        let holds = |own: &&Stretch| {
            let (from, to) = (own.sides[0].from, own.sides[own.sides.len() - 1].to);
            (from - self.slack..=to + self.slack).contains(&spot.at)
        };
        let stretch = face.iter().filter(holds).max_by(|a, b| a.height.total_cmp(&b.height));
        let Some(Stretch { sides, .. }) = stretch else { return Weights::new() };
        let (from, to) = spot.ends();
        if spot.width <= self.slack {
            let side = &sides[sides.partition_point(|side| side.to < spot.at).min(sides.len() - 1)];
            let at = side.reference(spot.at);
            let shapes = [0.5 * at * (at - 1.0), 1.0 - at * at, 0.5 * at * (at + 1.0)];
            return side.motions(spot.way).into_iter().zip(shapes).collect();
        }
        let first = sides.partition_point(|side| side.to <= from);
        let under = sides[first..].iter().take_while(|side| side.from < to);
        under.flat_map(|side| side.motions(spot.way).into_iter().zip(side.shares(from, to))).collect()
    }

    fn between(&self, one: &Weights, other: &Weights) -> f64 {
        let along = |(i, a): &(usize, f64)| a * other.iter().map(|(j, b)| b * self.influence[(*i, *j)]).sum::<f64>();
        one.iter().map(along).sum()
    }
}

impl Side {
    fn reference(&self, x: f64) -> f64 {
        (2.0 * x - self.from - self.to) / (self.to - self.from)
    }

    /// Numbers of its motions.
    fn motions(&self, way: Way) -> [usize; 3] {
        match way {
            Way::Down => self.down,
            Way::Along => self.along.unwrap_or(self.down),
        }
    }

    /// Shares of an even load of one from x to x (m) that its nodes take: the integrals of their shapes.
    fn shares(&self, from: f64, to: f64) -> [f64; 3] {
        let [a, b] = [from.max(self.from), to.min(self.to)].map(|x| self.reference(x));
        let [second, third] = [b * b - a * a, b * b * b - a * a * a];
        let factor = 0.5 * (self.to - self.from) / (to - from);
        [third / 6.0 - second / 4.0, (b - a) - third / 3.0, third / 6.0 + second / 4.0].map(|share| factor * share)
    }
}

impl Body {
    /// The body of E (Pa) and b (m).
    pub fn new(unit: Arc<Unit>, youngs_modulus: f64, width: f64) -> Self {
        Self { unit, youngs_modulus, width }
    }

    /// E·b, N/m.
    fn stiffness(&self) -> f64 {
        self.youngs_modulus * self.width
    }

    /// Its mesh.
    pub fn mesh(&self) -> &Mesh {
        self.unit.system.mesh()
    }

    /// Stress (σxx, σyy, σxy, that across) at every node for these displacements of the nodes (m), Pa.
    pub fn stresses(&self, displacements: &[[f64; 2]]) -> Vec<[f64; STRAINS]> {
        let own = nodal_stresses(self.mesh(), self.unit.system.law(), displacements, &[]);
        own.into_iter().map(|stress| stress.map(|stress| stress * self.youngs_modulus)).collect()
    }

    pub(super) fn deflection(&self, spot: &Spot, forces: &[(Spot, f64)]) -> f64 {
        let own = self.unit.weights(spot);
        let under = |(s, f): &(Spot, f64)| f * self.unit.between(&own, &self.unit.weights(s));
        forces.iter().map(under).sum::<f64>() / self.stiffness()
    }

    pub(super) fn influence(&self, spots: &[Spot]) -> DMatrix<f64> {
        let weights: Vec<Weights> = spots.iter().map(|spot| self.unit.weights(spot)).collect();
        DMatrix::from_fn(spots.len(), spots.len(), |i, j| {
            self.unit.between(&weights[i], &weights[j]) / self.stiffness()
        })
    }

    /// Displacements (x, y) of all nodes under downward forces that balance, beside the rigid motion a + b·x downwards, m.
    pub(super) fn displaced(&self, forces: &[(Spot, f64)], (a, b): (f64, f64)) -> Result<Vec<[f64; 2]>, ElasticError> {
        let mut loads = Loads::none(self.mesh());
        for (spot, force) in forces {
            for (number, weight) in self.unit.weights(spot) {
                let (node, way) = self.unit.motions[number];
                loads.add_force(node, way.direction().map(|c| c * weight * force / self.stiffness()));
            }
        }
        let moved = self.unit.system.solve(&loads)?.nodes;
        let with = |([x, y], [u, v]): (&[f64; 2], [f64; 2])| [u + b * y, v - a - b * x];
        Ok(self.mesh().nodes().iter().zip(moved).map(with).collect())
    }
}

/// Motions of nodes, numbered as they come up.
#[derive(Default)]
struct Motions {
    all: Vec<(usize, Way)>,
    numbers: HashMap<(usize, Way), usize>,
}

impl Motions {
    fn number(&mut self, node: usize, way: Way) -> usize {
        *self.numbers.entry((node, way)).or_insert_with(|| {
            self.all.push((node, way));
            self.all.len() - 1
        })
    }

    /// A face with the motions of its nodes, down and, if it `slides`, along it.
    fn of_face(&mut self, face: &[Level], slides: bool) -> Vec<Stretch> {
        let mut of_side = |LevelSide { from, to, nodes }: &LevelSide| {
            let down = nodes.map(|node| self.number(node, Way::Down));
            let along = slides.then(|| nodes.map(|node| self.number(node, Way::Along)));
            Side { from: *from, to: *to, down, along }
        };
        face.iter()
            .map(|own| Stretch { height: own.height, sides: own.sides.iter().map(&mut of_side).collect() })
            .collect()
    }
}

impl Way {
    /// The direction in the plane of a body, whose y is upwards.
    fn direction(self) -> [f64; 2] {
        match self {
            Self::Down => [0.0, -1.0],
            Self::Along => [1.0, 0.0],
        }
    }

    /// What of a displacement goes that way.
    fn of(self, [u, v]: [f64; 2]) -> f64 {
        match self {
            Self::Down => -v,
            Self::Along => u,
        }
    }
}

/// Motions of the first and the last node of a face.
fn ends(face: &[Stretch]) -> [usize; 2] {
    let (first, last) = (&face[0].sides, &face[face.len() - 1].sides);
    [first[0].down[0], last[last.len() - 1].down[2]]
}
