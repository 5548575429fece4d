//! Part of the residuals that a fitted mean absorbs.

use nalgebra::{DMatrix, DVector};

/// Projection of residuals z on the columns X of a mean, all whitened.
pub struct Mean {
    /// Squared length of the projection.
    pub square: f64,
    /// ln det XᵀX.
    pub log_determinant: f64,
    /// Number of their directions.
    pub rank: usize,
}

impl Mean {
    /// From XᵀX and Xᵀz. Columns may depend on each other: directions without length are left out.
    pub fn of(gram: &DMatrix<f64>, along: &DVector<f64>) -> Self {
        if along.is_empty() {
            return Self { square: 0.0, log_determinant: 0.0, rank: 0 };
        }
        let eigen = gram.clone().symmetric_eigen();
        let along = eigen.eigenvectors.tr_mul(along);
        let least = 1e-12 * eigen.eigenvalues.max();
        let told = || eigen.eigenvalues.iter().zip(along.iter()).filter(|(value, _)| **value > least);
        Self {
            square: told().map(|(value, a)| a * a / value).sum(),
            log_determinant: told().map(|(value, _)| value.ln()).sum(),
            rank: told().count(),
        }
    }
}
