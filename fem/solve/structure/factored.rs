//! A structure whose stiffness is factored.

use nalgebra::{DMatrix, SMatrix};
use nalgebra_sparse::{CooMatrix, CscMatrix};

use super::error::StructureError;
use super::{Direction, Freedom, Structure, freedoms};
use crate::solve::cholesky::{Factor, FactorError, Pattern, diagonal};
use crate::solve::selected::Selected;

/// Ratio of the softest motion's stiffness to that of its single freedoms below which nothing holds it: members a
/// thousand times as slender as they are long still have 1e-10.
const LOOSE: f64 = 1e-13;
/// What is added to a stiffness without a factor, relative, to find the motion that nothing holds.
const HELP: f64 = 1e-10;
/// Rounds in which the softest motion is found.
const ROUNDS: usize = 4;

/// A structure whose stiffness is factored.
pub struct Factored {
    pub(super) structure: Structure,
    /// Unknown of each freedom that is not held.
    unknowns: Vec<Option<usize>>,
    count: usize,
    factor: Factor,
}

impl Factored {
    pub(super) fn new(structure: Structure) -> Result<Self, StructureError> {
        let mut held = vec![false; 3 * structure.nodes.len()];
        structure.held.iter().for_each(|own| held[own.number()] = true);
        let mut count = 0;
        let unknowns: Vec<Option<usize>> = held
            .into_iter()
            .map(|held| {
                let own = (!held).then_some(count);
                count += usize::from(!held);
                own
            })
            .collect();
        let stiffness = assembled(&structure, &unknowns, count);
        let own: Vec<f64> = (0..count).map(|i| stiffness.values()[diagonal(&stiffness, i)]).collect();
        let loose = |motion: &[f64]| {
            let (at, nodes) = most(&structure, &unknowns, motion);
            StructureError::Loose { at, nodes }
        };
        if let Some(nothing) = own.iter().position(|own| *own <= 0.0) {
            let mut motion = vec![0.0; count];
            motion[nothing] = 1.0;
            return Err(loose(&motion));
        }
        let memory = |_| StructureError::OutOfMemory { unknowns: count };
        let pattern = Pattern::scattered(&stiffness).map_err(memory)?;
        match pattern.factor(&stiffness) {
            Ok(factor) => {
                // Where all is held nothing can move.
                if count > 0 {
                    let (ratio, motion) = softest(&factor, &own);
                    if ratio < LOOSE {
                        return Err(loose(&motion));
                    }
                }
                Ok(Self { structure, unknowns, count, factor })
            }
            Err(FactorError::OutOfMemory) => Err(StructureError::OutOfMemory { unknowns: count }),
            Err(FactorError::Pivot(_)) => {
                let mut helped = stiffness;
                for (i, own) in own.iter().enumerate() {
                    let at = diagonal(&helped, i);
                    helped.values_mut()[at] += HELP * own;
                }
                let factor = pattern.factor(&helped).map_err(memory)?;
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
        let mut right = vec![0.0; self.count];
        for (at, load) in loads {
            if let Some(unknown) = self.unknowns[at.number()] {
                right[unknown] += load;
            }
        }
        // What was factored is solved: the scratch is a vector, and memory for that there is.
        if self.factor.solve_in_place(&mut right).is_err() {
            right.fill(f64::NAN);
        }
        self.unknowns.iter().map(|own| own.map_or(0.0, |unknown| right[unknown])).collect()
    }

    /// Displacements of all freedoms under a unit load on each of some.
    pub fn under_each(&self, of: &[Freedom]) -> Vec<Vec<f64>> {
        of.iter().map(|own| self.under(&[(*own, 1.0)])).collect()
    }

    /// Compliance between the freedoms of the ends of each of some members, symmetric; m/N.
    pub fn of_ends(&self, members: &[usize]) -> Vec<SMatrix<f64, 6, 6>> {
        let selected = Selected::of(&self.factor);
        let of = |member: &usize| {
            let own = freedoms(self.structure.members[*member].0).map(|own| self.unknowns[own.number()]);
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

/// The upper triangle of the stiffness over the unknowns.
fn assembled(structure: &Structure, unknowns: &[Option<usize>], count: usize) -> CscMatrix<f64> {
    let mut matrix = CooMatrix::new(count, count);
    let mut add = |a: usize, b: usize, value: f64| {
        if let (Some(row), Some(column)) = (unknowns[a], unknowns[b])
            && row <= column
        {
            matrix.push(row, column, value);
        }
    };
    // Every diagonal entry is there, also of what nothing holds.
    (0..unknowns.len()).for_each(|own| add(own, own, 0.0));
    for (ends, member) in &structure.members {
        let stiffness = member.stiffness();
        let number = |k: usize| 3 * ends[k / 3] + k % 3;
        for row in 0..6 {
            (0..6).for_each(|column| add(number(row), number(column), stiffness[(row, column)]));
        }
    }
    for spring in &structure.springs {
        let (own, k) = (spring.at.number(), spring.stiffness);
        add(own, own, k);
        if let Some(node) = spring.from {
            let other = Freedom { node, ..spring.at }.number();
            add(other, other, k);
            add(own, other, -k);
            add(other, own, -k);
        }
    }
    CscMatrix::from(&matrix)
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
