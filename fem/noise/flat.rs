//! Columns whose amplitudes are free: a flat prior.

use nalgebra::{DMatrix, DVector};

use super::term::Column;

/// Whitened columns that are projected out.
#[derive(Clone, Debug)]
pub struct Flat {
    /// Orthonormal basis of the whitened columns.
    basis: DMatrix<f64>,
    /// Amplitudes of the columns per unit along each vector of the basis.
    amplitudes: DMatrix<f64>,
    /// The columns as the terms give them, SI, with the number of their term.
    given: Vec<(usize, Column)>,
    /// ln det FᵀV⁻¹F of the columns F, without directions of no length.
    pub log_determinant: f64,
}

impl Flat {
    /// Makes the projection of columns that are given both whitened and as they are; `None` where there are
    /// none.
    pub fn of(whitened: Vec<DVector<f64>>, given: Vec<(usize, Column)>) -> Option<Self> {
        if whitened.is_empty() {
            return None;
        }
        let columns = DMatrix::from_columns(&whitened);
        let eigen = (columns.transpose() * &columns).symmetric_eigen();
        // Groupings that cross share a direction, which counts once.
        let least = 1e-10 * eigen.eigenvalues.max();
        let told: Vec<usize> = (0..eigen.eigenvalues.len()).filter(|i| eigen.eigenvalues[*i] > least).collect();
        if told.is_empty() {
            return None;
        }
        let scaled = |i: &usize| eigen.eigenvectors.column(*i) / eigen.eigenvalues[*i].sqrt();
        let amplitudes = DMatrix::from_columns(&told.iter().map(scaled).collect::<Vec<DVector<f64>>>());
        let log_determinant = told.iter().map(|i| eigen.eigenvalues[*i].ln()).sum();
        Some(Self { basis: columns * &amplitudes, amplitudes, given, log_determinant })
    }

    /// Number of directions.
    pub fn count(&self) -> usize {
        self.basis.ncols()
    }

    /// Trace of the projection within the means of groups of rows, by the group of every row.
    pub fn between(&self, group: &[usize]) -> f64 {
        let groups = group.iter().max().map_or(0, |most| most + 1);
        let (mut sums, mut members) = (DMatrix::<f64>::zeros(groups, self.count()), vec![0.0; groups]);
        for (row, own) in group.iter().enumerate() {
            members[*own] += 1.0;
            let sum = sums.row(*own) + self.basis.row(row);
            sums.set_row(*own, &sum);
        }
        sums.row_iter().zip(members).filter(|(_, n)| *n > 0.0).map(|(sum, n)| sum.norm_squared() / n).sum()
    }

    /// Takes the columns out of whitened values.
    pub fn take_out(&self, values: &mut [f64]) {
        let all = DVector::from_column_slice(values);
        let left = &all - &self.basis * self.basis.tr_mul(&all);
        values.copy_from_slice(left.as_slice());
    }

    /// Contribution of each column to every row (SI), by least squares, given whitened residuals.
    pub fn contributions(&self, whitened: &[f64]) -> Vec<(usize, Column)> {
        let amplitudes = &self.amplitudes * self.basis.tr_mul(&DVector::from_column_slice(whitened));
        let scaled = |(column, a): (&(usize, Column), &f64)| {
            (column.0, column.1.iter().map(|(row, w)| (*row, w * a)).collect::<Column>())
        };
        self.given.iter().zip(amplitudes.iter()).map(scaled).collect()
    }
}
