//! The equations of a frame: numbering, stiffness, balance of forces.

use faer::fx128;
use nalgebra_sparse::{CooMatrix, CscMatrix};

use super::builder::Frame;
use super::error::SolveError;
use super::solution::{Convergence, Reaction, Solution};
use super::support::Resistance;
use crate::solve::cholesky::{Factor, FactorError, Pattern, diagonal};

/// Largest unbalanced force, relative to the loads, of a converged solution.
pub(super) const FORCE_TOLERANCE: f64 = 1e-10;
/// Largest last change of the displacements, relative to their size, of a converged solution.
pub(super) const INCREMENT_TOLERANCE: f64 = 1e-11;

/// Refinements before giving up: each gains the digits the factor is good for, usually six and more.
const MAX_REFINEMENTS: usize = 40;

/// Displacements of all degrees of freedom (m, rad; w of node i at 2i, θ at 2i + 1) in twofold precision:
/// forces are differences of displacements times large stiffnesses, and in plain doubles an element of 1/1000
/// of the shaft balances only to about 1e-8 of the load (estimate: 2⁻⁵³ × stiffness × displacement).
pub(super) type Motion = Vec<fx128>;

/// Numbering and stiffness of a frame without its joints.
pub(super) struct System<'f> {
    frame: &'f Frame,
    /// Degree of freedom of each unknown.
    free: Vec<usize>,
    /// Unknown of each degree of freedom that is not fixed.
    unknowns: Vec<Option<usize>>,
    /// Upper triangle of the stiffness of elements and springs over the unknowns.
    stiffness: CscMatrix<f64>,
    pattern: Pattern,
}

/// A factored stiffness, and what was added to its diagonal (freedom, N/m).
pub(super) struct Tangent {
    factor: Factor,
    added: Vec<(usize, f64)>,
}

impl<'f> System<'f> {
    /// Numbers and assembles; refuses a frame that is not held.
    pub fn new(frame: &'f Frame) -> Result<Self, SolveError> {
        if let Some(motion) = frame.loose_motion() {
            return Err(SolveError::Loose(motion));
        }
        let freedoms = 2 * frame.positions().len();
        let mut fixed = vec![false; freedoms];
        for support in frame.supports() {
            fixed[support.freedom()] |= matches!(support.resistance, Resistance::Fixed);
        }
        let free: Vec<usize> = (0..freedoms).filter(|&freedom| !fixed[freedom]).collect();
        let mut unknowns = vec![None; freedoms];
        for (unknown, &freedom) in free.iter().enumerate() {
            unknowns[freedom] = Some(unknown);
        }
        let stiffness = assemble(frame, &unknowns, free.len());
        let pattern = Pattern::banded(&stiffness).map_err(|error| failure(error, &free))?;
        Ok(Self { frame, free, unknowns, stiffness, pattern })
    }

    pub fn frame(&self) -> &'f Frame {
        self.frame
    }

    /// Own stiffness of a degree of freedom (N/m or N m/rad): the diagonal entry; infinite where fixed.
    pub fn own_stiffness(&self, freedom: usize) -> f64 {
        match self.unknowns[freedom] {
            Some(unknown) => self.stiffness.values()[diagonal(&self.stiffness, unknown)],
            None => f64::INFINITY,
        }
    }

    /// Factors the stiffness with `added` (freedom, stiffness in N/m) on its diagonal.
    pub fn tangent(&self, added: Vec<(usize, f64)>) -> Result<Tangent, SolveError> {
        let mut matrix = self.stiffness.clone();
        for &(freedom, stiffness) in &added {
            if let Some(unknown) = self.unknowns[freedom] {
                let entry = diagonal(&matrix, unknown);
                matrix.values_mut()[entry] += stiffness;
            }
        }
        let factor = self.pattern.factor(&matrix).map_err(|error| failure(error, &self.free))?;
        Ok(Tangent { factor, added })
    }

    /// Solves K u = f for `loads` f (N, N m, over all degrees of freedom) with the stiffness K of `tangent`.
    ///
    /// Iterative refinement: u += K⁻¹(f − F(u)) with the factored K and the forces F(u) of the elements in
    /// twofold precision, until the unbalanced force is below 1e-10 of the load and the change of u below
    /// 1e-12 of u.
    pub fn solve(&self, tangent: &Tangent, loads: &[f64]) -> Result<(Motion, Convergence), SolveError> {
        let mut motion = self.at_rest();
        let mut unbalanced = loads.to_vec();
        let mut convergence = Convergence::START;
        while convergence.iterations < MAX_REFINEMENTS {
            let mut change: Vec<f64> = self.free.iter().map(|&freedom| unbalanced[freedom]).collect();
            tangent.factor.solve_in_place(&mut change).map_err(|error| failure(error, &self.free))?;
            for (&freedom, &change) in self.free.iter().zip(&change) {
                motion[freedom] += fx128::from(change);
            }
            unbalanced = self.unbalanced(&motion, loads);
            for &(freedom, stiffness) in &tangent.added {
                unbalanced[freedom] -= stiffness * motion[freedom].0;
            }
            let change = self.free.iter().copied().zip(change);
            convergence = Convergence {
                iterations: convergence.iterations + 1,
                force_residual: ratio(self.force_size(&unbalanced), self.force_size(loads)),
                increment: ratio(largest(change, self.frame.length()), self.size(&motion)),
                joint_misfit: 0.0,
            };
            if convergence.force_residual <= FORCE_TOLERANCE && convergence.increment <= INCREMENT_TOLERANCE {
                return Ok((motion, convergence));
            }
        }
        Err(SolveError::NotConverged(convergence))
    }

    /// Forces f − F(u) over all degrees of freedom that elements and springs leave unbalanced under `loads`
    /// (N, N m). At a fixed one this is what the support carries.
    pub fn unbalanced(&self, motion: &Motion, loads: &[f64]) -> Vec<f64> {
        let mut forces = loads.to_vec();
        for (node, piece) in self.frame.pieces().iter().enumerate() {
            let first = 2 * node;
            let ends = [motion[first], motion[first + 1], motion[first + 2], motion[first + 3]];
            for (force, held) in forces[first..].iter_mut().zip(piece.end_forces(ends)) {
                *force -= held;
            }
        }
        for support in self.frame.supports() {
            if let Resistance::Spring(stiffness) = support.resistance {
                forces[support.freedom()] -= stiffness * motion[support.freedom()].0;
            }
        }
        forces
    }

    /// Size of `forces` at the unknowns (N): the largest force, or moment over the shaft's length.
    pub fn force_size(&self, forces: &[f64]) -> f64 {
        largest(self.free.iter().map(|&freedom| (freedom, forces[freedom])), 1.0 / self.frame.length())
    }

    /// All displacements zero.
    pub fn at_rest(&self) -> Motion {
        vec![fx128::ZERO; self.unknowns.len()]
    }

    /// Adds `step` times `change` to `motion`.
    pub fn advance(&self, motion: &mut Motion, change: &Motion, step: f64) {
        for (displacement, &change) in motion.iter_mut().zip(change) {
            *displacement += fx128::from(step) * change;
        }
    }

    /// Size of the displacements (m): the largest of |w| and |θ| times the shaft's length.
    pub fn size(&self, motion: &Motion) -> f64 {
        largest(motion.iter().map(|displacement| displacement.0).enumerate(), self.frame.length())
    }

    /// The answer at `motion` under `loads`; `joint_forces` is what the joints carry (N), in their order
    /// among the supports.
    pub fn solution(&self, motion: &Motion, loads: &[f64], joint_forces: &[f64], convergence: Convergence) -> Solution {
        let unbalanced = self.unbalanced(motion, loads);
        let mut joint_forces = joint_forces.iter();
        let reactions = self.frame.supports().iter().map(|support| {
            let value = match support.resistance {
                Resistance::Spring(stiffness) => stiffness * motion[support.freedom()].0,
                Resistance::Fixed => unbalanced[support.freedom()],
                Resistance::Joint(_) => joint_forces.next().copied().unwrap_or_default(),
            };
            Reaction { node: support.node, support: support.kind(), value }
        });
        Solution {
            reactions: reactions.collect(),
            displacement: motion.iter().step_by(2).map(|w| w.0).collect(),
            rotation: motion.iter().skip(1).step_by(2).map(|theta| theta.0).collect(),
            convergence,
        }
    }
}

/// Largest size among (degree of freedom, value), those of rotations times `rotation_factor`; NaN if any is.
fn largest(values: impl Iterator<Item = (usize, f64)>, rotation_factor: f64) -> f64 {
    values.fold(0.0, |largest, (freedom, value)| {
        let size = if freedom.is_multiple_of(2) { value.abs() } else { value.abs() * rotation_factor };
        if size.is_nan() || size > largest { size } else { largest }
    })
}

/// part / whole, 0 where both vanish (no load, no motion).
pub(super) fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

/// Upper triangle of Σ element stiffness + springs over the unknowns.
fn assemble(frame: &Frame, unknowns: &[Option<usize>], size: usize) -> CscMatrix<f64> {
    let mut matrix = CooMatrix::new(size, size);
    let mut add = |a: usize, b: usize, value: f64| {
        if let (Some(row), Some(column)) = (unknowns[a], unknowns[b])
            && row <= column
        {
            matrix.push(row, column, value);
        }
    };
    for (node, piece) in frame.pieces().iter().enumerate() {
        let stiffness = piece.stiffness();
        for row in 0..4 {
            for column in 0..4 {
                add(2 * node + row, 2 * node + column, stiffness[(row, column)]);
            }
        }
    }
    for support in frame.supports() {
        if let Resistance::Spring(stiffness) = support.resistance {
            add(support.freedom(), support.freedom(), stiffness);
        }
    }
    CscMatrix::from(&matrix)
}

/// A failed factorisation in terms of the shaft.
fn failure(error: FactorError, free: &[usize]) -> SolveError {
    match error {
        FactorError::Pivot(row) => {
            SolveError::NotPositiveDefinite { node: free.get(row).map_or(0, |freedom| freedom / 2) }
        }
        FactorError::OutOfMemory => SolveError::OutOfMemory { unknowns: free.len() },
    }
}
