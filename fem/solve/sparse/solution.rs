//! Factor once, solve often, and check every answer.

use super::error::FactorError;
use super::{Analysis, Factor, Freedoms, Matrix, SparseError};

/// Largest residual of an accepted solution, relative to |A||x| + |b|.
const ACCEPTED: f64 = 1e-11;
/// Residual below which refinement has nothing to gain.
const ROUNDING: f64 = 1e-14;

/// The accuracy with which a solution satisfies its equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// Largest entry of b − A x over max |A| max |x| + max |b|.
    pub residual: f64,
    /// Whether one step of refinement was taken.
    pub refined: bool,
}

/// A factored system. Vectors are in the order of the matrix.
#[derive(Clone, Debug)]
pub struct Solver {
    factor: Factor,
    scale: f64,
}

impl Solver {
    /// Factors the free part of `matrix`.
    ///
    /// # Errors
    /// [`SparseError::Singular`] names the node that is loose (`nodes` are the coordinates, m).
    pub fn new(
        analysis: &Analysis,
        matrix: &Matrix,
        freedoms: &Freedoms,
        nodes: &[[f64; 2]],
    ) -> Result<Self, SparseError> {
        let failed = |error| failure(error, freedoms, nodes);
        Ok(Self { factor: analysis.factor(matrix).map_err(failed)?, scale: matrix.largest() })
    }

    /// The factor.
    pub fn factor(&self) -> &Factor {
        &self.factor
    }

    /// Solves the free rows of A x = b for the free part of `x`, whose held part is given; `b` counts in free
    /// rows only. Checks the residual and refines once.
    ///
    /// # Errors
    /// [`SparseError::Inaccurate`].
    pub fn solve(&self, matrix: &Matrix, b: &[f64], x: &mut [f64]) -> Result<Accuracy, SparseError> {
        let free = matrix.pattern().free_rows.len();
        x[..free].fill(0.0);
        let mut residual = self.residual(matrix, b, x);
        let mut accuracy = Accuracy { residual: f64::INFINITY, refined: false };
        for refined in [false, true] {
            self.factor.solve_in_place(&mut residual[..free]);
            for (x, change) in x.iter_mut().zip(&residual[..free]) {
                *x += change;
            }
            residual = self.residual(matrix, b, x);
            accuracy = Accuracy { residual: self.relative(&residual[..free], b, x), refined };
            if accuracy.residual <= ROUNDING {
                break;
            }
        }
        // a residual that is not a number fails, too
        if accuracy.residual <= ACCEPTED {
            Ok(accuracy)
        } else {
            Err(SparseError::Inaccurate { residual: accuracy.residual })
        }
    }

    /// Overwrites `right_side` (over the free numbers) with the solution, without a check: for many steps of
    /// one system whose accuracy is checked by its balance.
    pub fn solve_unchecked(&self, right_side: &mut [f64]) {
        self.factor.solve_in_place(right_side);
    }

    fn residual(&self, matrix: &Matrix, b: &[f64], x: &[f64]) -> Vec<f64> {
        let mut residual = b.to_vec();
        matrix.multiply_add(-1.0, x, &mut residual);
        residual
    }

    fn relative(&self, residual: &[f64], b: &[f64], x: &[f64]) -> f64 {
        let size = |values: &[f64]| values.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        let whole = self.scale * size(x) + size(&b[..residual.len()]);
        // max drops NaN: look for it
        if residual.iter().any(|value| value.is_nan()) {
            f64::NAN
        } else if whole == 0.0 {
            0.0
        } else {
            size(residual) / whole
        }
    }
}

impl Analysis {
    /// Analyses the pattern of `matrix`.
    ///
    /// # Errors
    /// No memory.
    pub fn of(matrix: &Matrix) -> Result<Self, SparseError> {
        let unknowns = matrix.pattern().free_rows.len();
        Self::new(matrix.pattern()).map_err(|_| SparseError::OutOfMemory { unknowns })
    }
}

fn failure(error: FactorError, freedoms: &Freedoms, nodes: &[[f64; 2]]) -> SparseError {
    match error {
        FactorError::OutOfMemory => SparseError::OutOfMemory { unknowns: freedoms.free() },
        FactorError::Pivot(number) => {
            let freedom = freedoms.freedom(number);
            let (node, component) = (freedom / freedoms.components(), freedom % freedoms.components());
            SparseError::Singular { node, at: nodes[node], component }
        }
    }
}
