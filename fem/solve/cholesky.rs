//! Sparse Cholesky K = LLᵀ (faer) of frames: no dense blocks, one thread.

use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};
use nalgebra_sparse::CscMatrix;

/// Why a matrix has no factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::solve) enum FactorError {
    /// Pivot of this row (from 0) is zero, negative or not a number.
    Pivot(usize),
    OutOfMemory,
}

/// The pattern of the factor, found once for all matrices of one pattern.
pub(in crate::solve) struct Pattern {
    symbolic: Arc<SymbolicCholesky<usize>>,
}

/// A factored matrix.
pub(in crate::solve) struct Factor {
    pub(super) symbolic: Arc<SymbolicCholesky<usize>>,
    /// Of L; in columns, the diagonal first.
    pub(super) values: Vec<f64>,
}

/// Place of a diagonal entry among the values of an upper triangle: the last of its column.
pub(in crate::solve) fn diagonal(upper: &CscMatrix<f64>, unknown: usize) -> usize {
    upper.col_offsets()[unknown + 1] - 1
}

/// faer's view of the pattern of `upper`, without a copy; its checks cannot fail on what nalgebra-sparse has
/// checked.
fn pattern_view(upper: &CscMatrix<f64>) -> SymbolicSparseColMatRef<'_, usize> {
    SymbolicSparseColMatRef::new_checked(upper.nrows(), upper.ncols(), upper.col_offsets(), None, upper.row_indices())
}

impl Pattern {
    /// Analyses the pattern of the symmetric matrix whose upper triangle is `upper`, a band: natural order, no fill outside.
    pub fn banded(upper: &CscMatrix<f64>) -> Result<Self, FactorError> {
        Self::ordered(upper, SymmetricOrdering::Identity)
    }

    /// The same of any pattern: approximate minimum degree.
    pub fn scattered(upper: &CscMatrix<f64>) -> Result<Self, FactorError> {
        Self::ordered(upper, SymmetricOrdering::Amd)
    }

    fn ordered(upper: &CscMatrix<f64>, ordering: SymmetricOrdering<'_, usize>) -> Result<Self, FactorError> {
        let params = CholeskySymbolicParams {
            // frames are too narrow for dense blocks; the scalar path also reports the failed pivot by its row
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SIMPLICIAL,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_cholesky(pattern_view(upper), Side::Upper, ordering, params)
            .map_err(|_| FactorError::OutOfMemory)?;
        Ok(Self { symbolic: Arc::new(symbolic) })
    }

    /// Factors `upper`, which must have the pattern this was made from.
    pub fn factor(&self, upper: &CscMatrix<f64>) -> Result<Factor, FactorError> {
        let matrix = SparseColMatRef::new(pattern_view(upper), upper.values());
        let mut values = vec![0.0; self.symbolic.len_val()];
        let scratch = self.symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default());
        let mut memory = MemBuffer::try_new(scratch).map_err(|_| FactorError::OutOfMemory)?;
        self.symbolic
            .factorize_numeric_llt(
                &mut values,
                matrix,
                Side::Upper,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                Default::default(),
            )
            // the simplicial path counts pivots from 1
            .map_err(|LltError::NonPositivePivot { index }| FactorError::Pivot(index.saturating_sub(1)))?;
        Ok(Factor { symbolic: Arc::clone(&self.symbolic), values })
    }
}

impl Factor {
    /// Overwrites `right_side` with the solution.
    pub fn solve_in_place(&self, right_side: &mut [f64]) -> Result<(), FactorError> {
        let scratch = self.symbolic.solve_in_place_scratch::<f64>(1, Par::Seq);
        let mut memory = MemBuffer::try_new(scratch).map_err(|_| FactorError::OutOfMemory)?;
        let rows = right_side.len();
        LltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(right_side, rows, 1),
            Par::Seq,
            MemStack::new(&mut memory),
        );
        Ok(())
    }
}
