//! A covariance of rows that is known.

use nalgebra::{DMatrix, DVector};

/// Known covariance of rows, with what whitens them. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenCovariance {
    matrix: DMatrix<f64>,
    /// Lower factor of the correlation, L·Lᵀ = R (Cholesky).
    factor: DMatrix<f64>,
}

impl GivenCovariance {
    /// Takes a symmetric matrix; `None` where it is not positive definite.
    pub fn new(matrix: DMatrix<f64>) -> Option<Self> {
        let sigma = matrix.diagonal().map(f64::sqrt);
        if !sigma.iter().all(|s| s.is_finite() && *s > 0.0) {
            return None;
        }
        let correlation =
            DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)] / (sigma[i] * sigma[j]));
        let factor = correlation.cholesky()?.unpack();
        Some(Self { matrix, factor })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.matrix.nrows()
    }

    /// Standard uncertainty of each row.
    pub fn sigma(&self) -> Vec<f64> {
        self.matrix.diagonal().iter().map(|v| v.sqrt()).collect()
    }

    /// Covariance of some of the rows, in this order.
    pub fn some(&self, rows: &[usize]) -> Option<Self> {
        Self::new(DMatrix::from_fn(rows.len(), rows.len(), |i, j| self.matrix[(rows[i], rows[j])]))
    }

    /// Frees values, in standard uncertainties, of their correlation.
    pub fn free(&self, values: &mut [f64]) {
        let mut all = DVector::from_column_slice(values);
        if self.factor.solve_lower_triangular_mut(&mut all) {
            values.copy_from_slice(all.as_slice());
        }
    }

    /// ln det R
    pub fn log_determinant(&self) -> f64 {
        2.0 * self.factor.diagonal().iter().map(|d| d.ln()).sum::<f64>()
    }
}
