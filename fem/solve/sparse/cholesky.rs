//! Sparse Cholesky A = LLᵀ of the free part of an ordered matrix: analysis and supernodes by faer, numbers in
//! `numeric`, solves in `triangles`.
//!
//! The matrix is already in elimination order, so that nothing is permuted.

use std::sync::Arc;

use faer::Side;
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering, factorize_symbolic_cholesky,
};

use super::error::FactorError;
use super::triangles::{Halves, Triangles};
use super::{Matrix, Pattern, numeric};

/// Pivot over diagonal entry below which a freedom counts as loose: rounding leaves some 1e-16 of the entry,
/// the softest sound meshes (a million unknowns in a slender body) more than 1e-11.
const LOOSE: f64 = 1e-13;

/// The supernodes: always there, because the analysis was told to make them.
fn supernodes(symbolic: &SymbolicCholesky<u32>) -> Option<&SymbolicSupernodalCholesky<u32>> {
    match symbolic.raw() {
        SymbolicCholeskyRaw::Supernodal(symbolic) => Some(symbolic),
        SymbolicCholeskyRaw::Simplicial(_) => None,
    }
}

/// The pattern of the factor, found once for all matrices of one pattern.
#[derive(Clone, Debug)]
pub struct Analysis {
    symbolic: Arc<SymbolicCholesky<u32>>,
    halves: Option<Halves>,
}

/// A factored matrix.
#[derive(Clone, Debug)]
pub struct Factor {
    symbolic: Arc<SymbolicCholesky<u32>>,
    halves: Option<Halves>,
    values: Vec<f64>,
}

impl Analysis {
    pub(super) fn new(pattern: &Pattern) -> Result<Self, FactorError> {
        let (starts, rows) = pattern.leading_upper();
        let size = pattern.free_rows.len();
        let upper = SymbolicSparseColMatRef::new_checked(size, size, &starts, None, &rows);
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_cholesky(upper, Side::Upper, SymmetricOrdering::Identity, params)
            .map_err(|_| FactorError::OutOfMemory)?;
        let halves = supernodes(&symbolic).and_then(Halves::find);
        Ok(Self { symbolic: Arc::new(symbolic), halves })
    }

    /// Entries of the factor, with the zeros that supernodes hold.
    pub fn entries(&self) -> usize {
        self.symbolic.len_val()
    }

    #[cfg(test)]
    pub(super) fn has_halves(&self) -> bool {
        self.halves.is_some()
    }

    /// Multiplications of the factorisation, counted by supernodes.
    pub fn operations(&self) -> f64 {
        let Some(symbolic) = supernodes(&self.symbolic) else { return 0.0 };
        let work = |node: usize| {
            let columns = symbolic.supernode_end()[node] - symbolic.supernode_begin()[node];
            let below = symbolic.supernode(node).pattern().len() as f64;
            (0..columns).map(|column| 0.5 * (below + f64::from(columns - column)).powi(2)).sum::<f64>()
        };
        (0..symbolic.n_supernodes()).map(work).sum()
    }

    pub(super) fn factor(&self, matrix: &Matrix) -> Result<Factor, FactorError> {
        let mut values = vec![0.0; self.symbolic.len_val()];
        if let Some(symbolic) = supernodes(&self.symbolic) {
            numeric::factor(symbolic, self.halves, matrix, &mut values)?;
        }
        let factor = Factor { symbolic: Arc::clone(&self.symbolic), halves: self.halves, values };
        match factor.loose(matrix) {
            Some(number) => Err(FactorError::Pivot(number)),
            None => Ok(factor),
        }
    }
}

impl Factor {
    /// The first number whose pivot is lost to rounding.
    fn loose(&self, matrix: &Matrix) -> Option<usize> {
        let symbolic = supernodes(&self.symbolic)?;
        (0..symbolic.n_supernodes()).find_map(|node| {
            let supernode = symbolic.supernode(node);
            let first = symbolic.supernode_begin()[node] as usize;
            let columns = symbolic.supernode_end()[node] as usize - first;
            let height = columns + supernode.pattern().len();
            let values = &self.values[symbolic.col_ptr_for_val()[node] as usize..];
            let pivot = |column: usize| values[column * height + column].powi(2);
            let lost = |&column: &usize| {
                let pivot = pivot(column);
                pivot.is_nan() || pivot <= LOOSE * matrix.diagonal(first + column)
            };
            (0..columns).find(lost).map(|column| first + column)
        })
    }

    /// Overwrites `right_side` (over the free numbers) with the solution.
    pub(super) fn solve_in_place(&self, right_side: &mut [f64]) {
        if let Some(symbolic) = supernodes(&self.symbolic) {
            Triangles { symbolic, values: &self.values }.solve(self.halves, right_side);
        }
    }

    /// Bytes held by the values.
    pub fn bytes(&self) -> usize {
        8 * self.values.len()
    }
}
