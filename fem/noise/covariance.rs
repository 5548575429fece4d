//! Covariance of rows that share noise, as what whitens them.
//!
//! V = D·(R + B·Bᵀ)·D with the rows' own standard uncertainties D, their correlation R, and the columns
//! that are shared, in standard uncertainties. The R of neighbours has a bidiagonal inverse factor, one that
//! is given is factored by Cholesky. The columns are dealt with by Woodbury's identity: with C = R^(−1/2)·B,
//! (1 + C·Cᵀ)^(−1/2) = 1 + C·M·Cᵀ, where M follows from the eigenvalues of CᵀC. Columns with a flat prior
//! are projected out at last, which is the limit of an infinite size; ln det V then holds ln det(FᵀV⁻¹F) of
//! these columns F in its place, as the restricted likelihood does. But for a given R, whitening is linear in
//! the number of rows.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::flat::Flat;
use super::given::GivenCovariance;
use super::term::{Acts, Column, Term};
use crate::measure::Measurements;

/// What rows share, relative to their own standard uncertainties.
#[derive(Clone, Debug)]
pub struct Covariance {
    correlation: Correlation,
    /// Shared columns, in standard uncertainties and freed of the correlation of neighbours.
    columns: Vec<Column>,
    /// The shared columns as the terms give them, SI, with the number of their term.
    given: Vec<(usize, Column)>,
    /// M of the module's description, and (1 + CᵀC)⁻¹.
    middle: Middle,
    /// Columns with a flat prior.
    flat: Option<Flat>,
    /// ln det(R + B·Bᵀ), with the flat columns as the module's description says.
    pub log_determinant: f64,
}

/// Correlation of the rows' own noise.
#[derive(Clone, Debug)]
enum Correlation {
    /// With the row before of the same observable; none at the first.
    Chain(Vec<Option<(usize, f64)>>),
    /// Of all rows.
    Given(Arc<GivenCovariance>),
}

#[derive(Clone, Debug)]
enum Middle {
    /// The columns touch no common row.
    Diagonal {
        whitening: Vec<f64>,
        inverse: Vec<f64>,
    },
    Full {
        whitening: DMatrix<f64>,
        inverse: DMatrix<f64>,
    },
}

impl Covariance {
    /// Makes what `terms` share between rows of the given standard uncertainties (SI); `None` where they
    /// share nothing.
    pub fn new(terms: &[Term], sigma: &[f64], measurements: &Measurements) -> Option<Self> {
        let correlation = Correlation::of(terms, sigma.len(), measurements);
        let (mut given, mut free) = (Vec::new(), Vec::new());
        for (number, term) in terms.iter().enumerate() {
            let Acts::Shared(columns) = term.effect.acts else { continue };
            if term.is_flat() {
                free.extend(columns(term, measurements).into_iter().map(|column| (number, column)));
            } else if term.size > 0.0 {
                let scaled = |c: Column| c.into_iter().map(|(row, w)| (row, w * term.size)).collect::<Column>();
                given.extend(columns(term, measurements).into_iter().map(|c| (number, scaled(c))));
            }
        }
        if given.is_empty() && free.is_empty() && correlation.is_none() {
            return None;
        }
        let columns: Vec<Column> = given.iter().map(|(_, column)| correlation.freed(sigma, column)).collect();
        let (middle, of_columns) = Middle::of(&columns, sigma.len());
        let log_determinant = correlation.log_determinant() + of_columns;
        let mut all = Self { correlation, columns, given, middle, flat: None, log_determinant };
        let whitened = |(_, column): &(usize, Column)| {
            let mut dense = vec![0.0; sigma.len()];
            column.iter().for_each(|(row, w)| dense[*row] = w / sigma[*row]);
            all.whiten(&mut dense);
            DVector::from_vec(dense)
        };
        let flat = Flat::of(free.iter().map(whitened).collect(), free.clone());
        all.log_determinant += flat.as_ref().map_or(0.0, |f| f.log_determinant);
        all.flat = flat;
        Some(all)
    }

    /// Number of directions that are free.
    pub fn free(&self) -> usize {
        self.flat.as_ref().map_or(0, Flat::count)
    }

    /// Part of them that the means of groups of rows hold.
    pub fn free_between(&self, group: &[usize]) -> f64 {
        self.flat.as_ref().map_or(0.0, |flat| flat.between(group))
    }

    /// Whitens values that are given in the rows' own standard uncertainties.
    pub fn whiten(&self, values: &mut [f64]) {
        self.correlation.free(values);
        let along = self.along(values);
        self.add(&self.middle.whitening(&along), values);
        if let Some(flat) = &self.flat {
            flat.take_out(values);
        }
    }

    /// Most probable amplitude of every shared column, given residuals of all rows (SI) with their own
    /// standard uncertainties: the contribution of each term to every row, SI, as (term, contribution).
    pub fn amplitudes(&self, residuals: &[f64], sigma: &[f64]) -> Vec<(usize, Column)> {
        let own = |left: &[f64]| left.iter().zip(sigma).map(|(r, s)| r / s).collect::<Vec<f64>>();
        let (mut left, mut all) = (residuals.to_vec(), Vec::new());
        if let Some(flat) = &self.flat {
            let mut whitened = own(&left);
            self.correlation.free(&mut whitened);
            let along = self.along(&whitened);
            self.add(&self.middle.whitening(&along), &mut whitened);
            all = flat.contributions(&whitened);
            all.iter().flat_map(|(_, column)| column).for_each(|(row, v)| left[*row] -= v);
        }
        let mut values = own(&left);
        self.correlation.free(&mut values);
        let amplitudes = self.middle.inverse(&self.along(&values));
        let scaled = |(column, a): (&(usize, Column), &f64)| {
            (column.0, column.1.iter().map(|(row, w)| (*row, w * a)).collect::<Column>())
        };
        all.extend(self.given.iter().zip(&amplitudes).map(scaled));
        all
    }

    fn along(&self, values: &[f64]) -> Vec<f64> {
        self.columns.iter().map(|column| column.iter().map(|(row, w)| w * values[*row]).sum()).collect()
    }

    fn add(&self, amplitudes: &[f64], values: &mut [f64]) {
        for (column, amplitude) in self.columns.iter().zip(amplitudes) {
            column.iter().for_each(|(row, w)| values[*row] += w * amplitude);
        }
    }
}

impl Correlation {
    /// What the terms say of the rows' own noise.
    fn of(terms: &[Term], rows: usize, measurements: &Measurements) -> Self {
        let given = terms.iter().filter_map(|t| t.covariance.as_ref()).find(|given| given.rows() == rows);
        if let Some(given) = given {
            return Self::Given(given.clone());
        }
        let mut chain = vec![None; rows];
        if let Some(term) = terms.iter().find(|t| matches!(t.effect.acts, Acts::Neighbours)) {
            let coefficient = (-1.0 / term.size).exp();
            let mut before: Vec<Option<usize>> = vec![None; measurements.observables.len()];
            for (row, link) in chain.iter_mut().enumerate() {
                let last = &mut before[measurements.observable(row)];
                let is_same_file = |last: &usize| measurements.file_number(*last) == measurements.file_number(row);
                *link = last.filter(is_same_file).map(|last| (last, coefficient));
                *last = Some(row);
            }
        }
        Self::Chain(chain)
    }

    /// Whether rows are independent.
    fn is_none(&self) -> bool {
        matches!(self, Self::Chain(chain) if chain.iter().all(Option::is_none))
    }

    fn log_determinant(&self) -> f64 {
        match self {
            Self::Chain(chain) => chain.iter().flatten().map(|(_, c)| (1.0 - c * c).ln()).sum(),
            Self::Given(given) => given.log_determinant(),
        }
    }

    /// A shared column in standard uncertainties, freed of the correlation.
    fn freed(&self, sigma: &[f64], column: &Column) -> Column {
        if self.is_none() {
            return column.iter().map(|(row, w)| (*row, w / sigma[*row])).collect();
        }
        let mut dense = vec![0.0; sigma.len()];
        column.iter().for_each(|(row, w)| dense[*row] = w / sigma[*row]);
        self.free(&mut dense);
        dense.into_iter().enumerate().filter(|(_, w)| *w != 0.0).collect()
    }

    /// Frees values of the correlation; of that with the rows before them, the last first, so that each still
    /// finds the one before it as it was.
    fn free(&self, values: &mut [f64]) {
        let chain = match self {
            Self::Given(given) => return given.free(values),
            Self::Chain(chain) => chain,
        };
        for row in (0..values.len()).rev() {
            if let Some((before, c)) = chain[row] {
                values[row] = (values[row] - c * values[before]) / (1.0 - c * c).sqrt();
            }
        }
    }
}

/// ((1 + s)^(−1/2) − 1)/s, which is −1/2 at s = 0.
fn shrink(s: f64) -> f64 {
    let root = (1.0 + s).sqrt();
    -1.0 / (root * (1.0 + root))
}

impl Middle {
    /// Of some columns over `rows` rows, with ln det(1 + C·Cᵀ).
    fn of(columns: &[Column], rows: usize) -> (Self, f64) {
        let mut owner = vec![usize::MAX; rows];
        let mut apart = true;
        for (number, column) in columns.iter().enumerate() {
            for (row, _) in column {
                apart &= owner[*row] == usize::MAX;
                owner[*row] = number;
            }
        }
        if apart {
            let squares: Vec<f64> = columns.iter().map(|c| c.iter().map(|(_, w)| w * w).sum()).collect();
            let log_determinant = squares.iter().map(|s: &f64| s.ln_1p()).sum();
            let whitening = squares.iter().map(|s| shrink(*s)).collect();
            let inverse = squares.iter().map(|s| 1.0 / (1.0 + s)).collect();
            return (Self::Diagonal { whitening, inverse }, log_determinant);
        }
        let mut dense = DMatrix::zeros(rows, columns.len());
        for (number, column) in columns.iter().enumerate() {
            column.iter().for_each(|(row, w)| dense[(*row, number)] = *w);
        }
        let eigen = (dense.transpose() * dense).symmetric_eigen();
        let values = eigen.eigenvalues.map(|s| s.max(0.0));
        let with = |f: fn(f64) -> f64| {
            &eigen.eigenvectors * DMatrix::from_diagonal(&values.map(f)) * eigen.eigenvectors.transpose()
        };
        let log_determinant = values.iter().map(|s| s.ln_1p()).sum();
        (Self::Full { whitening: with(shrink), inverse: with(|s| 1.0 / (1.0 + s)) }, log_determinant)
    }

    fn whitening(&self, along: &[f64]) -> Vec<f64> {
        match self {
            Self::Diagonal { whitening, .. } => whitening.iter().zip(along).map(|(m, a)| m * a).collect(),
            Self::Full { whitening, .. } => (whitening * DVector::from_column_slice(along)).data.into(),
        }
    }

    fn inverse(&self, along: &[f64]) -> Vec<f64> {
        match self {
            Self::Diagonal { inverse, .. } => inverse.iter().zip(along).map(|(m, a)| m * a).collect(),
            Self::Full { inverse, .. } => (inverse * DVector::from_column_slice(along)).data.into(),
        }
    }
}
