//! How far fitted values may go together from a minimum. The covariance there says it to first order; where the prediction bends on the
//! way, other terms of the values are straighter (c·Fⁿ with an exponent that the data hardly tell is a ridge in ln c), or χ² ends the way
//! earlier.

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use rayon::prelude::*;

use super::objective::{Objective, Solution};
use crate::input::Bounds;
use crate::model::Spread;
use crate::process::Neutral;

/// Part of its value that a standard uncertainty has at least where its terms matter.
const WIDE: f64 = 0.1;
/// Bend of the prediction, all together in units of the noise, that is none.
const STRAIGHT: f64 = 0.1;
/// Part of the bend that other terms must leave to be taken.
const BETTER: f64 = 0.5;

/// What is known of the values at a minimum.
pub struct Spreading<'s, 'a> {
    objective: &'s Objective<'a>,
    solution: &'s Solution,
    values: Vec<f64>,
    /// Standard uncertainties, SI.
    deviations: Vec<f64>,
    /// Directions in which the values are independent of each other, one standard deviation long, in these.
    ways: DMatrix<f64>,
}

impl<'s, 'a> Spreading<'s, 'a> {
    /// That of a covariance of the values; `None` where it is none.
    pub fn of(objective: &'s Objective<'a>, solution: &'s Solution, covariance: &DMatrix<f64>) -> Option<Self> {
        /// Most steps to the eigenvalues, which take a few each.
        const MOST: usize = 1000;
        let deviations = deviations(covariance);
        if deviations.is_empty() || deviations.iter().any(|own| !own.is_finite()) {
            return None;
        }
        let own = SymmetricEigen::try_new(correlation(covariance, &deviations), f64::EPSILON, MOST)?;
        let mut ways = own.eigenvectors;
        for (mut way, variance) in ways.column_iter_mut().zip(&own.eigenvalues) {
            way *= variance.max(0.0).sqrt();
        }
        Some(Self { objective, solution, values: objective.values(&solution.position), deviations, ways })
    }

    /// The prediction so far along a way.
    fn predicted(&self, spreads: &[Spread], way: usize, by: f64) -> Option<(DVector<f64>, Vec<f64>)> {
        let at = |i: usize| spreads[i].away(self.values[i], by * self.deviations[i] * self.ways[(i, way)]);
        let count = self.values.len();
        let position = (0..count).map(|i| self.objective.variables[i].position(at(i)));
        let position = DVector::from_iterator(count, position);
        let predicted = self.objective.predict(&position)?;
        Some((position, predicted))
    }

    /// By how much the prediction bends along all ways, in units of the noise.
    fn bend(&self, spreads: &[Spread]) -> f64 {
        let of = |way: usize| match (self.predicted(spreads, way, 1.0), self.predicted(spreads, way, -1.0)) {
            (Some((_, up)), Some((_, down))) => {
                let all = up.iter().zip(&down).zip(&self.solution.predicted);
                self.objective.whiten(all.map(|((up, down), here)| up + down - 2.0 * here)).norm()
            }
            _ => f64::INFINITY,
        };
        (0..self.values.len()).into_par_iter().map(of).sum()
    }

    /// Other terms than the usual ones in which a value may be spread.
    fn others(&self, i: usize) -> &'static [Spread] {
        let entry = self.objective.catalogue(i);
        match self.objective.parameters[i].bounds {
            _ if self.deviations[i] <= WIDE * self.values[i].abs() || self.values[i] == 0.0 => &[],
            Bounds::Positive => &[Spread::Reciprocal],
            Bounds::Any | Bounds::NotNegative if entry.is_some_and(|own| own.neutral == Neutral::Value(0.0)) => {
                &[Spread::Logarithm]
            }
            _ => &[],
        }
    }

    /// The terms of each value in which the prediction is the straightest: the usual ones unless others are much better.
    pub fn spreads(&self) -> Vec<Spread> {
        let mut best: Vec<Spread> = self.objective.parameters.iter().map(Spread::usual).collect();
        let mut open: Vec<usize> = (0..self.values.len()).filter(|i| !self.others(*i).is_empty()).collect();
        if open.is_empty() {
            return best;
        }
        let width = |i: usize| self.deviations[i] / self.values[i].abs();
        open.sort_by(|a, b| width(*b).total_cmp(&width(*a)));
        let mut least = self.bend(&best);
        for i in open {
            for other in self.others(i) {
                if least < STRAIGHT {
                    return best;
                }
                let mut trial = best.clone();
                trial[i] = *other;
                let own = self.bend(&trial);
                if own < BETTER * least {
                    (best, least) = (trial, own);
                }
            }
        }
        best
    }

    /// The covariance of the values, each way as long as χ² lets it be: where that rises by more than one along a standard deviation,
    /// as s² + b·s⁴, up to where it has risen by one.
    pub fn limited(&self, spreads: &[Spread]) -> DMatrix<f64> {
        let rise = |way: usize, by: f64| {
            let (position, predicted) = self.predicted(spreads, way, by)?;
            Some(self.objective.residuals(&position, &predicted).norm_squared() - self.solution.chi2)
        };
        let length = |way: usize| {
            let both: Vec<f64> = [1.0, -1.0].iter().filter_map(|by| rise(way, *by)).collect();
            let more = both.iter().sum::<f64>() / both.len() as f64 - 1.0;
            if more > 0.0 { (((1.0 + 4.0 * more).sqrt() - 1.0) / (2.0 * more)).sqrt() } else { 1.0 }
        };
        let lengths: Vec<f64> = (0..self.values.len()).into_par_iter().map(length).collect();
        let mut ways = self.ways.clone();
        for (mut way, length) in ways.column_iter_mut().zip(&lengths) {
            way *= *length;
        }
        for (mut row, deviation) in ways.row_iter_mut().zip(&self.deviations) {
            row *= *deviation;
        }
        &ways * ways.transpose()
    }
}

/// Standard deviations of a covariance.
pub fn deviations(covariance: &DMatrix<f64>) -> Vec<f64> {
    covariance.diagonal().iter().map(|variance| variance.max(0.0).sqrt()).collect()
}

/// Correlations of a covariance; what does not vary is correlated with nothing.
pub fn correlation(covariance: &DMatrix<f64>, deviations: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(deviations.len(), deviations.len(), |i, j| {
        let both = deviations[i] * deviations[j];
        match i == j {
            true => 1.0,
            false if both > 0.0 => (covariance[(i, j)] / both).clamp(-1.0, 1.0),
            false => 0.0,
        }
    })
}
