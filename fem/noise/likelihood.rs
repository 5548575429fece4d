//! Likelihoods by which effects of the measurement are weighed against each other and their sizes estimated.

use nalgebra::{DMatrix, DVector};

use super::mean::Mean;
use super::size_profile::SizeProfile;
use super::{Acts, Noise, Term};
use crate::measure::Measurements;

/// Steps of the search for one size, and rounds over all of them.
const STEPS: usize = 24;
const ROUNDS: usize = 3;
/// (√5 − 1)/2
const GOLDEN: f64 = 0.618_033_988_749_895;

/// Restricted likelihood (Patterson and Thompson 1971) of residuals from which the columns of a mean were
/// fitted: the sizes of the terms follow from what the mean cannot touch.
pub struct Restricted<'a> {
    /// Measurements whose noise is sought.
    pub measurements: &'a Measurements,
    /// Residuals of all rows, SI.
    pub residuals: &'a [f64],
    /// Derivatives of the prediction of all rows, SI per unit of each free variable, and datum directions.
    pub mean: &'a DMatrix<f64>,
}

impl Restricted<'_> {
    /// −2 ln of the restricted likelihood, less a constant.
    pub fn minus_two_log(&self, noise: &Noise) -> f64 {
        let (square, of_mean, _) = self.parts(noise);
        noise.log_determinant() + of_mean + square
    }

    /// The columns of the mean, whitened; those of which free directions of the noise leave only round-off are left
    /// out.
    fn mean_under(&self, noise: &Noise) -> DMatrix<f64> {
        /// Length of a column over its length in the rows' own standard uncertainties.
        const ROUND_OFF: f64 = 1e-9;
        let length =
            |column: &[f64]| column.iter().zip(noise.sigma.iter()).map(|(v, s)| (v / s).powi(2)).sum::<f64>().sqrt();
        let whitened = |column: Vec<f64>| {
            let before = length(&column);
            let white = DVector::from_vec(noise.whiten(column));
            (white.norm() > ROUND_OFF * before).then_some(white)
        };
        let own = self.mean.column_iter().filter_map(|c| whitened(c.iter().copied().collect()));
        let columns: Vec<DVector<f64>> = own.collect();
        if columns.is_empty() { DMatrix::zeros(self.residuals.len(), 0) } else { DMatrix::from_columns(&columns) }
    }

    /// Square of the whitened residuals that no column of the mean can touch, ln det(XᵀV⁻¹X), and the
    /// degrees of freedom.
    fn parts(&self, noise: &Noise) -> (f64, f64, f64) {
        let z = DVector::from_vec(noise.whiten(self.residuals.iter().copied()));
        let x = self.mean_under(noise);
        let mean = Mean::of(&x.tr_mul(&x), &x.tr_mul(&z));
        let freedom = (z.len() - mean.rank).saturating_sub(noise.free_directions());
        ((z.norm_squared() - mean.square).max(0.0), mean.log_determinant, freedom as f64)
    }

    /// The noise with the sizes of the last `free` of `terms` at their most likely values, beside `own`; the
    /// level of all noise is sought too where it comes from no column.
    pub fn estimate(&self, own: &Noise, terms: &[Term], free: usize) -> Noise {
        let mut terms = terms.to_vec();
        let first = terms.len() - free;
        let is_flat: Vec<bool> = terms.iter().map(Term::is_flat).collect();
        let level = self.measurements.observables.iter().map(|s| own.usual(self.measurements, s.position));
        let level = level.fold(f64::INFINITY, f64::min);
        let mut noise = self.scaled(own.with(terms.clone(), self.measurements), first);
        for _ in 0..if free > 1 { ROUNDS } else { 1 } {
            for i in (first..terms.len()).filter(|i| !is_flat[*i]) {
                let (low, high) = match terms[i].effect.acts {
                    Acts::Shared(_) => {
                        let usual = terms[i].observable.map_or(level, |o| own.usual(self.measurements, o));
                        (0.02 * usual, 1e4 * usual)
                    }
                    // Correlations from e^-5 to 0.95 between neighbours.
                    Acts::Neighbours => (0.2, 20.0),
                    Acts::Scales => (0.1, 100.0),
                    _ => continue,
                };
                let size = match self.size_profile(own, &terms, i, first) {
                    Some(profile) => golden(low.ln(), high.ln(), |log_size| profile.minus_two_log(log_size.exp())),
                    None => golden(low.ln(), high.ln(), |log_size| {
                        terms[i].size = log_size.exp();
                        self.minus_two_log(&self.scaled(own.with(terms.clone(), self.measurements), first))
                    }),
                };
                terms[i].size = size.exp();
                noise = self.scaled(own.with(terms.clone(), self.measurements), first);
            }
        }
        noise
    }

    /// The likelihood by the size of one term beside the others; `None` where the noise of the others, or its level,
    /// does not stay as it is while the size changes.
    fn size_profile(&self, own: &Noise, terms: &[Term], number: usize, known: usize) -> Option<SizeProfile> {
        let is_stated = terms.iter().take(known).any(|t| matches!(t.effect.acts, Acts::Shared(_)));
        let is_rounded = terms.iter().any(|t| matches!(t.effect.acts, Acts::Rounds));
        if !own.source.is_known() && (is_stated || is_rounded) {
            return None;
        }
        let others = terms.iter().enumerate().filter(|(i, _)| *i != number).map(|(_, term)| term.clone());
        let others = own.with(others.collect(), self.measurements);
        SizeProfile::new(&others, &terms[number], self.residuals, &self.mean_under(&others), self.measurements)
    }

    /// Ends of the 95 % interval of the size of a term, where −2 ln L has risen by the quantile of χ² with
    /// one degree of freedom; an open end is `None`.
    pub fn interval(&self, noise: &Noise, number: usize) -> [Option<f64>; 2] {
        /// 95 % point of χ² with one degree of freedom.
        const QUANTILE: f64 = 3.841_458_820_694_124;
        /// Largest ratio of an end to the size, and halvings of it.
        const FAR: f64 = 1e4;
        const HALVINGS: usize = 20;
        let size = noise.terms[number].size;
        let least = self.minus_two_log(noise);
        let rise = |at: f64| self.profile(noise, number, at) - least;
        [1.0 / FAR, FAR].map(|far| {
            if rise(size * far) < QUANTILE {
                return None;
            }
            let (mut inside, mut outside) = (0.0, far.ln());
            for _ in 0..HALVINGS {
                let middle: f64 = 0.5 * (inside + outside);
                let is_inside = rise(size * middle.exp()) < QUANTILE;
                *if is_inside { &mut inside } else { &mut outside } = middle;
            }
            Some(size * f64::exp(inside))
        })
    }

    /// −2 ln L with another size of a term; the level of the rows' own noise follows where it comes from no
    /// column.
    fn profile(&self, noise: &Noise, number: usize, size: f64) -> f64 {
        let resized = noise.resized(number, size, self.measurements);
        let level = if noise.source.is_known() { resized } else { self.levelled(&resized) };
        self.minus_two_log(&level)
    }

    /// Noise with the most likely level of what the rows have to themselves; what they share stays.
    fn levelled(&self, noise: &Noise) -> Noise {
        /// Largest ratio by which the level follows.
        const FOLLOWS: f64 = 1e3;
        let at = |log_ratio: f64| noise.levelled(log_ratio.exp(), self.measurements);
        at(golden(-FOLLOWS.ln(), FOLLOWS.ln(), |log_ratio| self.minus_two_log(&at(log_ratio))))
    }

    /// Noise whose level is what the residuals ask for, where it comes from no column. Terms are counted in units
    /// of the rows' own noise while the level is sought, unless some sizes, the first `known`, are stated.
    fn scaled(&self, noise: Noise, known: usize) -> Noise {
        if noise.source.is_known() {
            return noise;
        }
        if noise.terms.iter().take(known).any(|t| matches!(t.effect.acts, Acts::Shared(_))) {
            return self.levelled(&noise);
        }
        let (square, _, freedom) = self.parts(&noise);
        let factor = (square / freedom.max(1.0)).sqrt();
        if factor > 0.0 { noise.times(factor, self.measurements) } else { noise }
    }
}

/// Place of the smallest value between two places, by golden section.
fn golden(mut low: f64, mut high: f64, mut f: impl FnMut(f64) -> f64) -> f64 {
    let (mut a, mut b) = (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut at_a, mut at_b) = (f(a), f(b));
    for _ in 0..STEPS {
        if at_a < at_b {
            (high, b, at_b) = (b, a, at_a);
            a = high - GOLDEN * (high - low);
            at_a = f(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = low + GOLDEN * (high - low);
            at_b = f(b);
        }
    }
    if at_a < at_b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::FILE;
    use crate::noise::tests::measured;
    use crate::noise::{NoiseSource, effects};

    #[test]
    fn the_profile_of_a_size_is_the_likelihood_itself() {
        // Twelve rows with a drift and a step, a constant fitted, one row in three of larger uncertainty.
        let rows = measured(&(0..12).map(f64::from).collect::<Vec<_>>());
        let residuals: Vec<f64> = (0..12).map(|i| f64::from(i * i % 7) - 2.0 + 0.3 * f64::from(i)).collect();
        let sigma: Vec<f64> = (0..12).map(|i| if i % 3 == 0 { 2.0 } else { 1.0 }).collect();
        let mean = DMatrix::from_element(12, 1, 1.0);
        let restricted = Restricted { measurements: &rows, residuals: &residuals, mean: &mean };
        let step = Term { rows: vec![5], size: 1.5, ..Term::new(&effects::JUMP) };
        let drift = Term { size: 1.0, ..Term::new(&effects::DRIFT) };
        let zeros = Term { by: vec![FILE], size: f64::INFINITY, ..Term::new(&effects::ZERO_SHIFT) };
        for source in [NoiseSource::Column, NoiseSource::Estimated] {
            let own = Noise::independent(sigma.clone(), source);
            for terms in [vec![drift.clone()], vec![step.clone(), drift.clone()], vec![zeros.clone(), drift.clone()]] {
                let number = terms.len() - 1;
                let Some(profile) = restricted.size_profile(&own, &terms, number, 0) else { panic!("{source:?}") };
                let at = |size: f64| {
                    let mut terms = terms.clone();
                    terms[number].size = size;
                    restricted.minus_two_log(&restricted.scaled(own.with(terms, &rows), 0))
                };
                for size in [0.01, 0.7, 3.0, 50.0] {
                    // Less the same constant.
                    let own = profile.minus_two_log(size) - profile.minus_two_log(1.0);
                    assert!((own - (at(size) - at(1.0))).abs() < 1e-8, "{source:?} {size}: {own}");
                }
            }
        }
    }
}
