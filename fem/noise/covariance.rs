//! Covariance of rows that share noise, as what whitens them.
//!
//! V = D·(R + B·Bᵀ)·D with the rows' own standard uncertainties D, their correlation R, and the columns
//! that are shared, in standard uncertainties. The R of neighbours has a bidiagonal inverse factor, one that
//! is given is factored by Cholesky. The columns are dealt with by Woodbury's identity: with C = R^(−1/2)·B,
//! (1 + C·Cᵀ)^(−1/2) = 1 + C·M·Cᵀ, where M follows from the eigenvalues of CᵀC. They are dealt with in two
//! stages: as many as touch no common row, for which CᵀC is diagonal, and the others, whitened by the first
//! stage, after them. Columns with a flat prior are projected out at last, which is the limit of an infinite size; ln det V then holds ln det(FᵀV⁻¹F) of
//! these columns F in its place, as the restricted likelihood does. But for a given R, whitening is linear in
//! the number of rows.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::flat::Flat;
use super::given::GivenCovariance;
use super::term::{Acts, Column, Term};
use crate::measure::Measurements;
use crate::process::Values;

/// Covariance of the rows, relative to their own standard uncertainties.
#[derive(Clone, Debug)]
pub struct Covariance {
    correlation: Correlation,
    /// Shared columns, in standard uncertainties and freed of the correlation of neighbours.
    columns: Vec<Column>,
    /// The shared columns as the terms give them, SI, with the number of their term.
    given: Vec<(usize, Column)>,
    /// Whitening by the shared columns, in two stages one after the other.
    stages: Vec<Stage>,
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

/// Whitens by some of the shared columns.
#[derive(Clone, Debug)]
struct Stage {
    /// Shared columns, whitened by the stages before.
    columns: Vec<Column>,
    /// M of the module's description.
    middle: Middle,
}

#[derive(Clone, Debug)]
enum Middle {
    /// The columns touch no common row.
    Diagonal(Vec<f64>),
    Full(DMatrix<f64>),
}

impl Covariance {
    /// Makes what `terms` share between rows of the given standard uncertainties (SI); `None` where they
    /// share nothing.
    pub fn new(terms: &[Term], sigma: &Values, measurements: &Measurements) -> Option<Self> {
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
        let (stages, of_columns) = Stage::all(&columns, sigma.len());
        let log_determinant = correlation.log_determinant() + of_columns;
        let mut all = Self { correlation, columns, given, stages, flat: None, log_determinant };
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
        self.stages.iter().for_each(|stage| stage.whiten(values));
        if let Some(flat) = &self.flat {
            flat.take_out(values);
        }
    }

    /// Most probable amplitude of every shared column, given residuals of all rows (SI) with their own
    /// standard uncertainties: the contribution of each term to every row, SI, as (term, contribution).
    pub fn amplitudes(&self, residuals: &[f64], sigma: &Values) -> Vec<(usize, Column)> {
        let own = |left: &[f64]| left.iter().zip(sigma.iter()).map(|(r, s)| r / s).collect::<Vec<f64>>();
        let (mut left, mut all) = (residuals.to_vec(), Vec::new());
        if let Some(flat) = &self.flat {
            let mut whitened = own(&left);
            self.correlation.free(&mut whitened);
            self.stages.iter().for_each(|stage| stage.whiten(&mut whitened));
            all = flat.contributions(&whitened);
            all.iter().flat_map(|(_, column)| column).for_each(|(row, v)| left[*row] -= v);
        }
        let mut values = own(&left);
        self.correlation.free(&mut values);
        // Each stage is symmetric: there and back again they are (1 + C·Cᵀ)⁻¹.
        self.stages.iter().chain(self.stages.iter().rev()).for_each(|stage| stage.whiten(&mut values));
        let amplitudes = along(&self.columns, &values);
        let scaled = |(column, a): (&(usize, Column), &f64)| {
            (column.0, column.1.iter().map(|(row, w)| (*row, w * a)).collect::<Column>())
        };
        all.extend(self.given.iter().zip(&amplitudes).map(scaled));
        all
    }
}

/// Product of every column with the values of the rows.
fn along(columns: &[Column], values: &[f64]) -> Vec<f64> {
    columns.iter().map(|column| column.iter().map(|(row, w)| w * values[*row]).sum()).collect()
}

impl Correlation {
    /// Correlation of the rows' own noise by the terms: as given, else of neighbours, else none.
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
    fn freed(&self, sigma: &Values, column: &Column) -> Column {
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

impl Stage {
    /// The stages of some columns over `rows` rows, with ln det(1 + C·Cᵀ).
    fn all(columns: &[Column], rows: usize) -> (Vec<Self>, f64) {
        let mut is_touched = vec![false; rows];
        let mut apart = |column: &Column| {
            let apart = column.iter().all(|(row, _)| !is_touched[*row]);
            column.iter().filter(|_| apart).for_each(|(row, _)| is_touched[*row] = true);
            apart
        };
        // The shortest first: of them there are most.
        let mut rising = columns.to_vec();
        rising.sort_by_key(Vec::len);
        let (first, others): (Vec<Column>, Vec<Column>) = rising.into_iter().partition(|c| apart(c));
        let (first, log_determinant) = Self::of_columns_apart(first);
        if others.is_empty() {
            return (vec![first], log_determinant);
        }
        let mut dense = DMatrix::zeros(rows, others.len());
        for (mut own, column) in dense.column_iter_mut().zip(&others) {
            let mut values = vec![0.0; rows];
            column.iter().for_each(|(row, w)| values[*row] = *w);
            first.whiten(&mut values);
            own.copy_from_slice(&values);
        }
        let (second, of_second) = Self::of_any(&dense);
        (vec![first, second], log_determinant + of_second)
    }

    /// Of columns that touch no common row.
    fn of_columns_apart(columns: Vec<Column>) -> (Self, f64) {
        let squares: Vec<f64> = columns.iter().map(|c| c.iter().map(|(_, w)| w * w).sum()).collect();
        let log_determinant = squares.iter().map(|s: &f64| s.ln_1p()).sum();
        let middle = Middle::Diagonal(squares.iter().map(|s| shrink(*s)).collect());
        (Self { columns, middle }, log_determinant)
    }

    fn of_any(dense: &DMatrix<f64>) -> (Self, f64) {
        let eigen = (dense.transpose() * dense).symmetric_eigen();
        let values = eigen.eigenvalues.map(|s| s.max(0.0));
        let middle = &eigen.eigenvectors * DMatrix::from_diagonal(&values.map(shrink)) * eigen.eigenvectors.transpose();
        let sparse = |column: &[f64]| column.iter().copied().enumerate().filter(|(_, w)| *w != 0.0).collect();
        let columns = dense.column_iter().map(|column| sparse(column.as_slice())).collect();
        (Self { columns, middle: Middle::Full(middle) }, values.iter().map(|s| s.ln_1p()).sum())
    }

    /// Applies (1 + C·Cᵀ)^(−1/2) of its columns.
    fn whiten(&self, values: &mut [f64]) {
        let along = along(&self.columns, values);
        let amplitudes: Vec<f64> = match &self.middle {
            Middle::Diagonal(middle) => middle.iter().zip(&along).map(|(m, a)| m * a).collect(),
            Middle::Full(middle) => (middle * DVector::from_column_slice(&along)).data.into(),
        };
        for (column, amplitude) in self.columns.iter().zip(&amplitudes) {
            column.iter().for_each(|(row, w)| values[*row] += w * amplitude);
        }
    }
}
