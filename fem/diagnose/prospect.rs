//! What further rows are expected to tell about which of several predictions is true.
//!
//! Each prediction is a normal distribution of mean m and covariance C = I + LLᵀ in standard uncertainties of the rows: the
//! values that the data leave uncertain spread it along the columns of L. What the rows tell is the mutual information of
//! them and of which it is; of a mixture of normal distributions it is no less than
//!
//! −Σᵢ wᵢ ln Σⱼ wⱼ exp(−Bᵢⱼ), Bᵢⱼ = ⅛ δ² + ½ ln |C̄| − ¼ ln |Cᵢ||Cⱼ|, δ² = ΔᵀC̄⁻¹Δ, C̄ = ½(Cᵢ + Cⱼ)
//!
//! with Bhattacharyya's distances B (Kolchinsky and Tracey 2017, Entropy 19, 361). All of it is computed from inner products
//! of columns, for any number of repeats.

use std::ops::Range;

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

/// Predictions of some rows, by the inner products of the columns of their uncertainties and of their means.
#[derive(Clone)]
pub struct Prospect {
    weights: Vec<f64>,
    /// Columns of each prediction's L, and last its mean less that of the first.
    columns: Vec<Range<usize>>,
    products: DMatrix<f64>,
}

impl Prospect {
    /// Predictions with their weights: the columns of L, and last the mean, in standard uncertainties of rows that are
    /// measured once. `None` where there are none.
    pub fn new(predictions: Vec<(f64, Vec<DVector<f64>>)>) -> Option<Self> {
        let (mut weights, mut columns, mut all) = (Vec::new(), Vec::new(), Vec::new());
        for (weight, own) in predictions {
            weights.push(weight);
            columns.push(all.len()..all.len() + own.len());
            all.extend(own);
        }
        let first: DVector<f64> = all[columns.first()?.end - 1].clone();
        for own in &columns {
            all[own.end - 1] -= &first;
        }
        let all = DMatrix::from_columns(&all);
        let whole: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= whole);
        Some(Self { weights, columns, products: all.tr_mul(&all) })
    }

    /// The same predictions of these rows and of others.
    pub fn and(&self, other: &Self) -> Self {
        let products = &self.products + &other.products;
        Self { weights: self.weights.clone(), columns: self.columns.clone(), products }
    }

    /// I + r·MᵀM of some columns, factored, of rows that are repeated r times.
    fn factored(&self, own: &[usize], scale: f64) -> Option<Cholesky<f64, Dyn>> {
        let entry = |r: usize, c: usize| scale * self.products[(own[r], own[c])] + f64::from(u8::from(r == c));
        Cholesky::new(DMatrix::from_fn(own.len(), own.len(), entry))
    }

    fn log_determinant(factor: &Cholesky<f64, Dyn>) -> f64 {
        2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>()
    }

    fn spread(&self, i: usize) -> Range<usize> {
        self.columns[i].start..self.columns[i].end - 1
    }

    /// Squared distance δ² of two predictions, and Bhattacharyya's distance B, of rows that are repeated so often.
    pub fn apart(&self, i: usize, j: usize, repeats: f64) -> Option<(f64, f64)> {
        let both: Vec<usize> = self.spread(i).chain(self.spread(j)).collect();
        let (p, q) = (self.columns[i].end - 1, self.columns[j].end - 1);
        let along = |c: usize| self.products[(p, c)] - self.products[(q, c)];
        let square = along(p) - along(q);
        let factor = self.factored(&both, 0.5 * repeats)?;
        let shadow = DVector::from_iterator(both.len(), both.iter().map(|c| along(*c)));
        // (I + r·½MMᵀ)⁻¹ = I − r·½ M (I + r·½ MᵀM)⁻¹ Mᵀ
        let taken = 0.5 * repeats * shadow.dot(&factor.solve(&shadow));
        let distance = (repeats * (square - taken)).max(0.0);
        let own = |i: usize| Some(Self::log_determinant(&self.factored(&self.spread(i).collect::<Vec<_>>(), repeats)?));
        let volume = 0.5 * Self::log_determinant(&factor) - 0.25 * (own(i)? + own(j)?);
        Some((distance, 0.125 * distance + volume.max(0.0)))
    }

    /// What the rows tell, nats; `is_one` says of two predictions that nobody asks which of them is true.
    pub fn information(&self, is_one: impl Fn(usize, usize) -> bool, repeats: usize) -> f64 {
        let n = self.weights.len();
        let mut overlap = DMatrix::identity(n, n);
        for i in 0..n {
            for j in 0..i {
                let apart = if is_one(i, j) { None } else { self.apart(i, j, repeats as f64) };
                let both = apart.map_or(1.0, |(_, b)| (-b).exp());
                (overlap[(i, j)], overlap[(j, i)]) = (both, both);
            }
        }
        let seen = overlap * DVector::from_column_slice(&self.weights);
        -self.weights.iter().zip(seen.iter()).map(|(w, seen)| w * seen.ln()).sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn vector(values: [f64; 3]) -> DVector<f64> {
        DVector::from_column_slice(&values)
    }

    #[test]
    fn two_that_are_sure_of_their_values_are_told_by_their_distance() {
        let at = |x: f64| (0.5, vec![vector([x, 0.0, 0.0])]);
        let prospect = Prospect::new(vec![at(1.0), at(4.0)]).unwrap();
        // δ² = 9 once, 36 in four repeats; −ln ½(1 + exp(−δ²/8)).
        for (repeats, square) in [(1, 9.0), (4, 36.0)] {
            let by_hand = -(0.5 * (1.0 + f64::exp(-square / 8.0))).ln();
            assert!((prospect.information(|_, _| false, repeats) - by_hand).abs() < 1e-12);
            assert!((prospect.apart(0, 1, repeats as f64).unwrap().0 - square).abs() < 1e-12);
        }
        assert_eq!(prospect.information(|_, _| true, 4), 0.0);
    }

    #[test]
    fn rows_and_more_rows_are_all_rows() {
        let of = |rows: [f64; 3], spread: [f64; 3], weight| (weight, vec![vector(spread), vector(rows)]);
        let part = |from: usize, count: usize, (weight, columns): &(f64, Vec<DVector<f64>>)| {
            (*weight, columns.iter().map(|c| c.rows(from, count).into_owned()).collect::<Vec<_>>())
        };
        let all = [of([1.0, -2.0, 0.5], [0.4, 1.1, -0.3], 0.6), of([0.2, 1.5, 2.5], [-0.9, 0.1, 0.7], 0.4)];
        let of_rows = |from, count| Prospect::new(all.iter().map(|own| part(from, count, own)).collect()).unwrap();
        let whole = of_rows(0, 3).information(|_, _| false, 2);
        let both = of_rows(0, 2).and(&of_rows(2, 1)).information(|_, _| false, 2);
        assert!((whole - both).abs() < 1e-12 && whole > of_rows(0, 2).information(|_, _| false, 2));
    }

    #[test]
    fn distances_are_those_of_the_matrices() {
        let (one, other) = (vector([0.3, -1.2, 0.8]), [vector([2.0, 0.5, 0.1]), vector([-0.4, 0.9, 1.7])]);
        let (m, n) = (vector([1.0, 2.0, 3.0]), vector([0.5, -1.0, 4.0]));
        let prospect = Prospect::new(vec![
            (0.7, vec![one.clone(), m.clone()]),
            (0.3, vec![other[0].clone(), other[1].clone(), n.clone()]),
        ]);
        let covariances = [
            DMatrix::identity(3, 3) + &one * one.transpose(),
            DMatrix::identity(3, 3) + &other[0] * other[0].transpose() + &other[1] * other[1].transpose(),
        ];
        let mean = 0.5 * (&covariances[0] + &covariances[1]);
        let apart = m - n;
        let square = (apart.transpose() * mean.clone().try_inverse().unwrap() * &apart)[(0, 0)];
        let volume = 0.5 * mean.determinant().ln()
            - 0.25 * (covariances[0].determinant().ln() + covariances[1].determinant().ln());
        let (distance, bhattacharyya) = prospect.unwrap().apart(0, 1, 1.0).unwrap();
        assert!((distance - square).abs() < 1e-12 && (bhattacharyya - (0.125 * square + volume)).abs() < 1e-12);
    }
}
