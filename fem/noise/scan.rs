//! Where a term of the noise stands: the row of a step, the period of a wave, whichever gains most.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::Noise;
use super::term::{Acts, Term};
use crate::measure::Measurements;

/// Places at which a step of the zero is looked for.
const STEPS: usize = 240;
/// Fewest rows on either side of a step: fewer are wrong themselves.
const LEAST_SIDE: usize = 3;
/// Fewest periods of a wave: a part of one is a curve, which many laws make.
const LEAST_PERIODS: f64 = 2.0;
/// Fewest places along which a wave runs, and most of its periods.
const LEAST_PLACES: usize = 8;
const MOST_PERIODS: f64 = 64.0;
/// Steps of the scan over periods, in parts of a period over the whole range: a wave between two of them loses
/// less than a tenth of its square.
const FINENESS: f64 = 4.0;
/// Part of the largest column below which nothing of a column is left beside others.
const ROUND_OFF: f64 = 1e-9;
/// Halvings of the distance to the best period.
const REFINEMENTS: usize = 12;

/// Whitened residuals from which the fitted parameters are taken out, and columns that are tried on them.
pub struct Scan<'a> {
    measurements: &'a Measurements,
    noise: &'a Noise,
    /// Orthonormal basis of what the fitted parameters can imitate, whitened.
    basis: DMatrix<f64>,
    residual: DVector<f64>,
}

impl<'a> Scan<'a> {
    /// Whitens the residuals, and what the parameters can imitate.
    pub fn new(measurements: &'a Measurements, noise: &'a Noise, residuals: &[f64], mean: &DMatrix<f64>) -> Self {
        let white = |values: Vec<f64>| DVector::from_vec(noise.whiten(values));
        let mean: Vec<_> = mean.column_iter().map(|c| white(c.iter().copied().collect())).collect();
        let basis =
            if mean.is_empty() { DMatrix::zeros(residuals.len(), 0) } else { DMatrix::from_columns(&mean).qr().q() };
        Self { measurements, noise, basis, residual: white(residuals.to_vec()) }
    }

    /// Fall of χ² when the columns of a term are fitted, each with a free amplitude.
    fn gain(&self, term: &Term) -> f64 {
        let Acts::Shared(columns) = term.effect.acts else { return 0.0 };
        let mut left = self.residual.clone();
        let mut own: Vec<DVector<f64>> = Vec::new();
        let mut gain = 0.0;
        for column in columns(term, self.measurements) {
            let mut dense = vec![0.0; self.measurements.len()];
            column.into_iter().for_each(|(row, weight)| dense[row] = weight);
            let mut column = DVector::from_vec(self.noise.whiten(dense));
            column -= &self.basis * (self.basis.transpose() * &column);
            own.iter().for_each(|o| column -= o * o.dot(&column));
            let length = column.norm().max(1e-5);
            column /= length;
            let along = column.dot(&left);
            gain += along * along;
            left.axpy(-along, &column, 1.0);
            own.push(column);
        }
        gain
    }

    /// The best of some terms.
    fn best(&self, terms: Vec<Term>) -> Option<Term> {
        let gains: Vec<f64> = terms.par_iter().map(|term| self.gain(term)).collect();
        let best = (0..terms.len()).max_by(|a, b| gains[*a].total_cmp(&gains[*b]))?;
        terms.into_iter().nth(best)
    }

    /// The step at the row that gains most.
    pub fn step(&self, term: &Term) -> Option<Term> {
        let rows = self.measurements.len();
        let at = |row: usize| Term { rows: vec![row], ..term.clone() };
        let stride = rows.div_ceil(STEPS);
        let (first, last) = (LEAST_SIDE, rows.checked_sub(LEAST_SIDE)?);
        let coarse = self.best((first..=last).step_by(stride).map(at).collect())?.rows[0];
        self.best((coarse.saturating_sub(stride).max(first)..=(coarse + stride).min(last)).map(at).collect())
    }

    /// The same without what differs from one level of the rows to the next.
    pub fn beside(&self, levels: &[usize]) -> Self {
        let mut columns = vec![vec![0.0; levels.len()]; levels.iter().max().map_or(0, |most| most + 1)];
        levels.iter().enumerate().for_each(|(row, level)| columns[*level][row] = 1.0);
        let white = |column: Vec<f64>| DVector::from_vec(self.noise.whiten(column));
        let own = columns.into_iter().map(white);
        let all: Vec<_> = self.basis.column_iter().map(|column| column.into_owned()).chain(own).collect();
        let factors = DMatrix::from_columns(&all).col_piv_qr();
        let sizes = factors.r().diagonal().map(f64::abs);
        let rank = sizes.iter().filter(|size| **size > ROUND_OFF * sizes[0]).count();
        let basis = factors.q().columns(0, rank).into_owned();
        let residual = &self.residual - &basis * basis.tr_mul(&self.residual);
        Self { measurements: self.measurements, noise: self.noise, basis, residual }
    }

    /// The wave along the coordinate of a term with the period that gains most; around an angle a whole number of
    /// them. `None` where the places are too few to show one.
    pub fn wave(&self, term: &Term) -> Option<Term> {
        let along = term.along?;
        let x = &self.measurements.rows.columns[along.coordinate];
        let is_own = |row: &usize| term.is_of(self.measurements, *row) && x[*row].is_finite();
        let mut places: Vec<f64> = (0..x.len()).filter(is_own).map(|row| x[row]).collect();
        places.sort_unstable_by(f64::total_cmp);
        places.dedup();
        let (low, high) = (*places.first()?, *places.last()?);
        let range = if along.is_angle { std::f64::consts::TAU } else { high - low };
        // Two places a period are the least that show it.
        let most = (0.5 * (places.len() - 1) as f64).min(MOST_PERIODS);
        if places.len() < LEAST_PLACES || range <= 0.0 || most < LEAST_PERIODS {
            return None;
        }
        let of = |periods: f64| Term { period: Some(range / periods), ..term.clone() };
        let step = if along.is_angle { 1.0 } else { 1.0 / FINENESS };
        let count = ((most - LEAST_PERIODS) / step) as usize;
        let mut best = self.best((0..=count).map(|i| of(LEAST_PERIODS + step * i as f64)).collect())?;
        if along.is_angle {
            return Some(best);
        }
        for refinement in 1..=REFINEMENTS {
            let here = range / best.period?;
            let apart = step * 0.5f64.powi(refinement as i32);
            let beside = [here - apart, here, here + apart].map(|p| of(p.clamp(LEAST_PERIODS, most)));
            best = self.best(beside.to_vec())?;
        }
        Some(best)
    }
}
