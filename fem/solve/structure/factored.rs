//! A structure whose stiffness is factored.

use std::sync::Arc;

use nalgebra::{DMatrix, SMatrix};

use super::error::StructureError;
use super::plan::Plan;
use super::{Direction, Freedom, Structure, freedoms};
use crate::solve::cholesky::{Factor, FactorError, diagonal};
use crate::solve::selected::Selected;

/// Ratio of the softest motion's stiffness to that of its single freedoms below which nothing holds it: members a
/// thousand times as slender as they are long still have 1e-10.
const LOOSE: f64 = 1e-13;
/// What is added to a stiffness without a factor, relative, to find the motion that nothing holds.
const HELP: f64 = 1e-10;
/// Rounds in which the softest motion is found.
const ROUNDS: usize = 4;
/// Ratio above which it is beyond doubt that something holds it: a motion that nothing holds grows by the inverse of its
/// ratio in the first round, and some of every motion is in what that begins with.
const HELD: f64 = 1e-7;

/// A structure whose stiffness is factored.
pub struct Factored {
    pub(super) structure: Structure,
    plan: Arc<Plan>,
    factor: Factor,
}

impl Factored {
    /// Assembles and factors a structure by the plan of its topology.
    ///
    /// # Errors
    /// Something can move without resistance, or memory does not suffice.
    pub fn new(structure: Structure, plan: Arc<Plan>) -> Result<Self, StructureError> {
        let count = plan.count();
        let stiffness = plan.assembled(&structure);
        let own: Vec<f64> = (0..count).map(|i| stiffness.values()[diagonal(&stiffness, i)]).collect();
        let loose = |motion: &[f64]| {
            let (at, nodes) = most(&structure, &plan.unknowns, motion);
            StructureError::Loose { at, nodes }
        };
        if let Some(nothing) = own.iter().position(|own| *own <= 0.0) {
            let mut motion = vec![0.0; count];
            motion[nothing] = 1.0;
            return Err(loose(&motion));
        }
        match plan.order.factor(&stiffness) {
            Ok(factor) => {
                // Where all is held nothing can move.
                if count > 0 {
                    let (ratio, motion) = softest(&factor, &own);
                    if ratio < LOOSE {
                        return Err(loose(&motion));
                    }
                }
                Ok(Self { structure, plan, factor })
            }
            Err(FactorError::OutOfMemory) => Err(StructureError::OutOfMemory { unknowns: count }),
            Err(FactorError::Pivot(_)) => {
                let mut helped = stiffness;
                for (i, own) in own.iter().enumerate() {
                    let at = diagonal(&helped, i);
                    helped.values_mut()[at] += HELP * own;
                }
                let memory = |_| StructureError::OutOfMemory { unknowns: count };
                let factor = plan.order.factor(&helped).map_err(memory)?;
                Err(loose(&softest(&factor, &own).1))
            }
        }
    }

    /// What is factored.
    pub fn structure(&self) -> &Structure {
        &self.structure
    }

    /// Displacements of all freedoms under loads (N, N m) on some: u, v, θ of node i at 3i, 3i + 1, 3i + 2.
    pub fn under(&self, loads: &[(Freedom, f64)]) -> Vec<f64> {
        let mut right = vec![0.0; self.plan.count()];
        for (at, load) in loads {
            if let Some(unknown) = self.plan.unknowns[at.number()] {
                right[unknown] += load;
            }
        }
        // What was factored is solved: the scratch is a vector, and memory for that there is.
        if self.factor.solve_in_place(&mut right).is_err() {
            right.fill(f64::NAN);
        }
        self.plan.unknowns.iter().map(|own| own.map_or(0.0, |unknown| right[unknown])).collect()
    }

    /// Displacements of all freedoms under a unit load on each of some.
    pub fn under_each(&self, of: &[Freedom]) -> Vec<Vec<f64>> {
        of.iter().map(|own| self.under(&[(*own, 1.0)])).collect()
    }

    /// Compliance between the freedoms of the ends of each of some members, symmetric; m/N.
    pub fn of_ends(&self, members: &[usize]) -> Vec<SMatrix<f64, 6, 6>> {
        let selected = Selected::of(&self.factor);
        let of = |member: &usize| {
            let own = freedoms(self.structure.members[*member].0).map(|own| self.plan.unknowns[own.number()]);
            SMatrix::from_fn(|i, j| match (own[i], own[j]) {
                // The ends of a member are joined by its stiffness, so that their entries are in the pattern.
                (Some(i), Some(j)) => selected.as_ref().and_then(|own| own.at(i, j)).unwrap_or(f64::NAN),
                _ => 0.0,
            })
        };
        members.iter().map(of).collect()
    }

    /// Compliance between freedoms, symmetric: the displacement of the first under a unit load on the second; m/N.
    pub fn compliance(&self, of: &[Freedom]) -> DMatrix<f64> {
        let columns = self.under_each(of);
        DMatrix::from_fn(of.len(), of.len(), |i, j| 0.5 * (columns[j][of[i].number()] + columns[i][of[j].number()]))
    }
}

/// The softest motion by inverse iteration with every freedom in units of its own stiffness: its stiffness in those units, and
/// the motion.
fn softest(factor: &Factor, diagonal: &[f64]) -> (f64, Vec<f64>) {
    // Anything that has some of every motion in it.
    let mut motion: Vec<f64> = (0..diagonal.len()).map(|i| 1.0 + 0.5 * (1.7 * i as f64).sin()).collect();
    let mut ratio = 1.0;
    for _ in 0..ROUNDS {
        let size = motion.iter().map(|own| own * own).sum::<f64>().sqrt();
        motion.iter_mut().zip(diagonal).for_each(|(own, d)| *own *= d.sqrt() / size);
        if factor.solve_in_place(&mut motion).is_err() {
            break;
        }
        motion.iter_mut().zip(diagonal).for_each(|(own, d)| *own *= d.sqrt());
        ratio = 1.0 / motion.iter().map(|own| own * own).sum::<f64>().sqrt();
        if ratio > HELD {
            break;
        }
    }
    motion.iter_mut().zip(diagonal).for_each(|(own, d)| *own /= d.sqrt());
    (ratio, motion)
}

/// The freedom that moves most in a motion, turning counted by what it moves at the structure's size, and how many nodes
/// move in its direction at least half as far.
fn most(structure: &Structure, unknowns: &[Option<usize>], motion: &[f64]) -> (Freedom, usize) {
    let extent = |k: usize| {
        let of = |fold: fn(f64, f64) -> f64, start: f64| structure.nodes.iter().map(|own| own[k]).fold(start, fold);
        of(f64::max, f64::NEG_INFINITY) - of(f64::min, f64::INFINITY)
    };
    let size = extent(0).max(extent(1));
    let moved = |node: usize, direction: Direction| {
        let own = unknowns[Freedom { node, direction }.number()].map_or(0.0, |unknown| motion[unknown].abs());
        if direction == Direction::Turn { own * size } else { own }
    };
    let best = |ways: &[Direction]| {
        let all = (0..structure.nodes.len()).flat_map(|node| ways.iter().map(move |direction| (node, *direction)));
        let of = |(node, direction): (usize, Direction)| (moved(node, direction), Freedom { node, direction });
        all.map(of).fold((0.0, Freedom { node: 0, direction: ways[0] }), |a, b| if b.0 > a.0 { b } else { a })
    };
    let (along, turning) = (best(&[Direction::X, Direction::Y]), best(&[Direction::Turn]));
    // What turns as a whole also moves its nodes; where these stay, something turns in its place.
    let (most, at) = if along.0 > 1e-3 * turning.0 { along } else { turning };
    let together = (0..structure.nodes.len()).filter(|node| moved(*node, at.direction) >= 0.5 * most);
    (at, together.count())
}
