//! Sensitivities of many candidate effects beside one another: what the model's own parameters can imitate is
//! projected out of all of them at once, and their inner products are kept.
//!
//! With K columns over n rows the products cost K²·n multiplications, once. After that the gain of any set of
//! effects, to first order, and the distribution of the largest gain by chance need no row any more.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use super::gain::{Gain, gain};
use super::residual_projection::ProjectedResidual;
use super::sensitivity::CandidateEffect;

/// Part of the square of a column beyond the factor of the products: its draws are too short by half of that.
const LEFT_OUT: f64 = 1e-6;

/// A variant of a candidate effect with its place among the columns.
pub struct ScreenedVariant<'c> {
    /// Number of the candidate among those that are screened.
    pub candidate: usize,
    /// Number of the variant among the candidate's.
    pub variant: usize,
    /// Its columns.
    columns: Range<usize>,
    signed: &'c [bool],
}

/// Variants of candidate effects with the inner products of their columns.
pub struct Screening<'c> {
    /// Variants of which the rows show anything, by the numbers of their candidates.
    pub variants: Vec<ScreenedVariant<'c>>,
    /// Products of the columns with one another.
    gram: DMatrix<f64>,
    /// Products of the columns with the residual.
    along: DVector<f64>,
}

impl<'c> Screening<'c> {
    /// Projects and multiplies the columns of candidates.
    pub fn new(projected: &ProjectedResidual, candidates: &[&'c CandidateEffect]) -> Self {
        let mut variants = Vec::new();
        let mut columns: Vec<DVector<f64>> = Vec::new();
        for (candidate, effect) in candidates.iter().enumerate() {
            for (variant, own) in effect.variants.iter().enumerate() {
                let Some(left) = projected.seen(own) else { continue };
                let first = columns.len();
                columns.extend(left.column_iter().map(|column| column.into_owned()));
                variants.push(ScreenedVariant {
                    candidate,
                    variant,
                    columns: first..columns.len(),
                    signed: &own.signed,
                });
            }
        }
        let rows = projected.residual.len();
        let all = if columns.is_empty() { DMatrix::zeros(rows, 0) } else { DMatrix::from_columns(&columns) };
        let across = all.transpose();
        Self { gram: &across * &all, along: across * &projected.residual, variants }
    }

    /// Gain of two variants together.
    pub fn gain_of_pair(&self, one: &ScreenedVariant, other: &ScreenedVariant) -> Gain {
        let own: Vec<usize> = one.columns.clone().chain(other.columns.clone()).collect();
        self.gain(&own, &[one.signed, other.signed].concat(), |i| self.along[i])
    }

    /// Fall of χ² by a variant where `along` are the products of all columns with a residual.
    pub fn delta_chi2(&self, variant: &ScreenedVariant, along: &[f64]) -> f64 {
        let first = variant.columns.start;
        if let [signed] = variant.signed {
            let own = along[first];
            return if own > 0.0 || *signed { own * own / self.gram[(first, first)] } else { 0.0 };
        }
        let own: Vec<usize> = variant.columns.clone().collect();
        self.gain(&own, variant.signed, |i| along[i]).delta_chi2
    }

    fn gain(&self, own: &[usize], signed: &[bool], along: impl Fn(usize) -> f64) -> Gain {
        let n = own.len();
        let gram = DMatrix::from_fn(n, n, |r, c| self.gram[(own[r], own[c])]);
        gain(&gram, &DVector::from_fn(n, |r, _| along(own[r])), signed)
    }

    /// A factor L of the products, L·Lᵀ, with as few columns as are needed: products of the columns with white noise
    /// are L times as many normal numbers. Cholesky with complete pivoting, which stops when nothing is left (Higham
    /// 2002, section 10.3).
    pub fn factor(&self) -> DMatrix<f64> {
        let count = self.gram.nrows();
        let length: Vec<f64> = (0..count).map(|i| self.gram[(i, i)].sqrt()).collect();
        let mut left = vec![1.0f64; count];
        let mut columns: Vec<DVector<f64>> = Vec::new();
        while let Some(pivot) = (0..count).max_by(|i, j| left[*i].total_cmp(&left[*j])) {
            if left[pivot] < LEFT_OUT {
                break;
            }
            let mut column = DVector::from_fn(count, |i, _| self.gram[(i, pivot)] / (length[i] * length[pivot]));
            columns.iter().for_each(|before| column.axpy(-before[pivot], before, 1.0));
            column /= left[pivot].sqrt();
            left.iter_mut().zip(column.iter()).for_each(|(left, entry)| *left -= entry * entry);
            left[pivot] = 0.0;
            columns.push(column);
        }
        DMatrix::from_fn(count, columns.len(), |i, k| length[i] * columns[k][i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_columns_make_all_products() {
        // Forty decays over fifty rows, which are nearly alike: far fewer directions than columns.
        let decay = |k: usize, row: usize| (-(row as f64) / (5.0 + 2.0 * k as f64)).exp();
        let columns = DMatrix::from_fn(50, 40, |row, k| decay(k, row));
        let gram = columns.transpose() * &columns;
        let screening = Screening { variants: Vec::new(), along: DVector::zeros(40), gram: gram.clone() };
        let factor = screening.factor();
        assert!(factor.ncols() < 12, "{}", factor.ncols());
        for (i, j) in [(0, 0), (0, 39), (17, 23), (39, 39)] {
            let made = factor.row(i).dot(&factor.row(j));
            let scale = (gram[(i, i)] * gram[(j, j)]).sqrt();
            assert!((made - gram[(i, j)]).abs() < LEFT_OUT * scale, "{i} {j}");
        }
    }
}
