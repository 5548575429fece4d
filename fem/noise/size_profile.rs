//! Restricted likelihood as a function of the size of one term: everything that takes rows is done once.
//!
//! With rows whitened by all other terms, V = 1 + s²·Z·Zᵀ. The eigenvalues λ and eigenvectors of ZᵀZ give V⁻¹ and
//! ln det V for every s (Woodbury's identity), and the projections of the residual z and of the columns X of the mean
//! on Z are all that is needed of them.

use nalgebra::{DMatrix, DVector};

use super::mean::Mean;
use super::{Acts, Noise, Term};
use crate::measure::Measurements;

/// Residual, mean and the columns of one term, whitened by the noise of all else.
pub struct SizeProfile {
    /// λ.
    eigenvalues: Vec<f64>,
    /// Projections of z on Z times each eigenvector.
    of_residual: DVector<f64>,
    /// Those of X, a row for each column of X.
    of_mean: DMatrix<f64>,
    /// zᵀz, Xᵀz and XᵀX.
    square: f64,
    along: DVector<f64>,
    gram: DMatrix<f64>,
    /// Rows less directions that are free in the noise of all else.
    rows: f64,
    /// ln det of the noise of all else.
    log_determinant: f64,
    /// Whether the level of all noise follows from the residuals.
    is_level_free: bool,
}

impl SizeProfile {
    /// Whitens by `others`, which is the noise without the term; `x` are the columns of the mean, whitened by it.
    /// `None` where the term shares no columns.
    pub fn new(
        others: &Noise,
        term: &Term,
        residuals: &[f64],
        x: &DMatrix<f64>,
        measurements: &Measurements,
    ) -> Option<Self> {
        let Acts::Shared(columns) = term.effect.acts else { return None };
        let rows = residuals.len();
        let z = DVector::from_vec(others.whiten(residuals.iter().copied()));
        let dense = |column: Vec<(usize, f64)>| {
            let mut dense = vec![0.0; rows];
            column.into_iter().for_each(|(row, weight)| dense[row] = weight);
            DVector::from_vec(others.whiten(dense))
        };
        let own: Vec<DVector<f64>> = columns(term, measurements).into_iter().map(dense).collect();
        let shared = if own.is_empty() { DMatrix::zeros(rows, 0) } else { DMatrix::from_columns(&own) };
        let products = shared.transpose() * &shared;
        let is_diagonal = (0..own.len()).all(|i| (0..i).all(|j| products[(i, j)] == 0.0));
        let (eigenvalues, directions) = if is_diagonal {
            (products.diagonal(), DMatrix::identity(own.len(), own.len()))
        } else {
            let eigen = products.symmetric_eigen();
            (eigen.eigenvalues, eigen.eigenvectors)
        };
        let projected = shared * directions;
        Some(Self {
            eigenvalues: eigenvalues.iter().map(|value| value.max(0.0)).collect(),
            of_residual: projected.tr_mul(&z),
            of_mean: x.tr_mul(&projected),
            square: z.norm_squared(),
            along: x.tr_mul(&z),
            gram: x.tr_mul(x),
            rows: (rows - others.free_directions()) as f64,
            log_determinant: others.log_determinant(),
            is_level_free: !others.source.is_known(),
        })
    }

    /// −2 ln of the restricted likelihood at a size, less a constant; with the level of all noise at its most likely
    /// value where no column tells it.
    pub fn minus_two_log(&self, size: f64) -> f64 {
        let s2 = size * size;
        let taken: Vec<f64> = self.eigenvalues.iter().map(|value| s2 / (1.0 + s2 * value)).collect();
        let of_columns: f64 = self.eigenvalues.iter().map(|value| (s2 * value).ln_1p()).sum();
        let weighed = DMatrix::from_fn(self.of_mean.nrows(), taken.len(), |i, k| self.of_mean[(i, k)] * taken[k]);
        let of_residual: f64 = self.of_residual.iter().zip(&taken).map(|(a, t)| t * a * a).sum();
        let mean = Mean::of(
            &(&self.gram - &weighed * self.of_mean.transpose()),
            &(&self.along - &weighed * &self.of_residual),
        );
        let square = (self.square - of_residual - mean.square).max(0.0);
        let fixed = self.log_determinant + of_columns + mean.log_determinant;
        if !self.is_level_free {
            return fixed + square;
        }
        let freedom = (self.rows - mean.rank as f64).max(1.0);
        fixed + freedom * (1.0 + (square / freedom).max(f64::MIN_POSITIVE).ln())
    }
}
