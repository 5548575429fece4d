//! Noise of the measurements: from their own column, from repeats, or estimated from the residuals; and what
//! the rows share of it, by effects of the measurement itself.

mod caution;
mod chance;
mod contradiction;
mod covariance;
mod covariance_file;
pub mod effects;
mod evidence;
mod flat;
mod given;
mod instrument;
mod key;
mod level;
mod likelihood;
mod mean;
mod recurring;
mod scan;
mod size;
mod size_profile;
mod source;
mod suspects;
mod table;
mod term;

pub use caution::caution;
pub use chance::{beyond_chi2, beyond_f};
pub use contradiction::contradictions;
pub use effects::MEASUREMENT;
pub use evidence::{Evidence, PROMISING, own_observables};
pub use given::GivenCovariance;
pub use instrument::{at_true_times, behind, is_size_of, reading, time_of};
pub use key::{FROM, Key};
pub use level::NoiseLevel;
pub use likelihood::Restricted;
pub use recurring::recurs;
pub use size::{observed, size};
pub use suspects::{is_rough, is_round_off, suspects};
pub use table::read;
pub use term::{Acts, Along, Column, MeasurementEffect, Shape, Size, Term};

use std::borrow::Cow;
use std::sync::Arc;

use nalgebra::DMatrix;

use crate::measure::{Measurements, Repeats};
use crate::process::Values;
use covariance::Covariance;

/// Standard uncertainty of each row, and its source. SI units.
#[derive(Clone, Debug)]
pub struct Noise {
    /// Standard uncertainty of each row, without what it shares with others.
    pub sigma: Values,
    /// The same before any term changes it.
    own: Values,
    /// Source of the standard uncertainty.
    pub source: NoiseSource,
    /// Effects of the measurement that are at work.
    pub terms: Vec<Term>,
    /// Covariance of the rows by these terms; `None` where they share no noise.
    shared: Option<Arc<Covariance>>,
}

/// Source of the noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseSource {
    /// The column `u`.
    Column,
    /// A covariance of the rows that is known.
    Covariance,
    /// Rows that repeat each other (pure error).
    Repeats,
    /// Scatter of neighbouring residuals, which a smooth failing of the model hardly changes.
    Estimated,
}

impl NoiseSource {
    /// Whether the standard uncertainties are known, and not from the rows themselves.
    pub fn is_known(self) -> bool {
        matches!(self, Self::Column | Self::Covariance)
    }
}

impl Noise {
    /// Noise of rows on which terms are at work, without their shares yet, and the repeats within the groups
    /// that the terms set apart: what varies between groups is no noise of a row.
    pub fn beside(
        terms: &[Term],
        measurements: &Measurements,
        repeats: &Repeats,
        residuals: &[f64],
    ) -> (Self, Repeats) {
        let levels: Vec<Vec<usize>> = terms.iter().filter_map(|term| term.levels(measurements)).collect();
        let is_out = |row: usize| terms.iter().any(|t| matches!(t.effect.acts, Acts::Weighs) && t.rows.contains(&row));
        let repeats = if terms.is_empty() { repeats.clone() } else { repeats.within(measurements, &levels, &is_out) };
        let mut noise = Self::of(measurements, &repeats, residuals);
        if terms.iter().any(|t| matches!(t.effect.acts, Acts::Given)) {
            noise.source = NoiseSource::Covariance;
        }
        let neighbours = terms.iter().any(|t| matches!(t.effect.acts, Acts::Neighbours));
        if noise.source == NoiseSource::Repeats && neighbours {
            // Repeats that follow each other share what they are off by.
            noise.source = NoiseSource::Estimated;
        }
        (noise, repeats)
    }

    /// Noise of rows with the terms that a model states; sizes that are not a number are estimated, beside
    /// the columns of a `mean` that was fitted.
    pub fn stated(
        terms: &[Term],
        measurements: &Measurements,
        repeats: &Repeats,
        residuals: &[f64],
        mean: &DMatrix<f64>,
    ) -> (Self, Repeats) {
        let (own, within) = Self::beside(terms, measurements, repeats, residuals);
        if terms.is_empty() {
            return (own, within);
        }
        let is_free = |t: &Term| t.size.is_nan() && t.effect.acts.is_estimated();
        let (free, known): (Vec<Term>, Vec<Term>) = terms.iter().cloned().partition(is_free);
        let count = free.len();
        let terms: Vec<Term> = known.into_iter().chain(free.into_iter().map(|t| Term { size: 1.0, ..t })).collect();
        let restricted = Restricted { measurements, residuals, mean };
        (restricted.estimate(&own, &terms, count), within)
    }

    /// Gives all rows of an observable the same noise; `sigma` in the order of the file's observables.
    pub fn alike(measurements: &Measurements, sigma: &[f64], source: NoiseSource) -> Self {
        let of_row = |row: usize| sigma[measurements.observable(row)];
        Self::independent((0..measurements.len()).map(of_row).collect::<Values>(), source)
    }

    /// Noise that the rows do not share.
    pub fn independent(sigma: impl Into<Values>, source: NoiseSource) -> Self {
        let sigma = sigma.into();
        Self { own: sigma.clone(), sigma, source, terms: Vec::new(), shared: None }
    }

    /// The same noise with other terms.
    #[must_use]
    pub fn with(&self, terms: Vec<Term>, measurements: &Measurements) -> Self {
        let mut sigma = self.own.clone();
        for term in &terms {
            if matches!(term.effect.acts, Acts::Scales) {
                sigma = sigma.map(|s| s * term.size);
            }
        }
        self.round(&mut sigma, &terms, measurements);
        for term in terms.iter().filter(|t| matches!(t.effect.acts, Acts::Weighs)) {
            term.rows.iter().for_each(|row| sigma.set(*row, sigma[*row] * term.size));
        }
        let shared = Covariance::new(&terms, &sigma, measurements).map(Arc::new);
        Self { sigma, own: self.own.clone(), source: self.source, terms, shared }
    }

    /// Adds what rounding by the instrument makes to known uncertainties, and raises others to it.
    fn round(&self, sigma: &mut Values, terms: &[Term], measurements: &Measurements) {
        for term in terms.iter().filter(|t| matches!(t.effect.acts, Acts::Rounds)) {
            let variance = term.size * term.size / 12.0;
            for row in (0..sigma.len()).filter(|row| term.is_of(measurements, *row)) {
                let s = sigma[row];
                sigma.set(row, if self.source.is_known() { (s * s + variance).sqrt() } else { s.max(variance.sqrt()) });
            }
        }
    }

    /// Price of its terms in −2 ln L: ln n for every parameter, and what rows were chosen from.
    pub fn price(&self) -> f64 {
        self.terms.iter().map(|term| term.price(self.sigma.len())).sum()
    }

    /// Source of the level of the standard uncertainties: those that were scaled by the residuals do not tell it.
    pub fn source_of_level(&self) -> NoiseSource {
        let is_scaled = self.terms.iter().any(|t| matches!(t.effect.acts, Acts::Scales));
        if is_scaled { NoiseSource::Estimated } else { self.source }
    }

    /// The same noise, all of it larger by a factor.
    #[must_use]
    pub fn times(&self, factor: f64, measurements: &Measurements) -> Self {
        let mut own = self.own.clone();
        if !self.source.is_known() {
            self.round(&mut own, &self.terms, measurements);
        }
        let scaled = |term: &Term| match term.effect.acts {
            Acts::Shared(_) => Term { size: factor * term.size, ..term.clone() },
            _ => term.clone(),
        };
        let terms: Vec<Term> = self.terms.iter().map(scaled).collect();
        Self { own: own.map(|s| (factor * s).max(1e-15)), ..self.clone() }.with(terms, measurements)
    }

    /// Whether it is the other noise, all of it larger or smaller by one factor: then both have the same minimum.
    pub fn is_a_multiple_of(&self, other: &Self) -> bool {
        /// Largest relative difference between factors that is round-off.
        const ROUND_OFF: f64 = 1e-9;
        let Some((first, others)) = self.sigma.first().zip(other.sigma.first()) else { return false };
        let factor = first / others;
        let is_scaled = |own: f64, other: f64| own == factor * other || (own - factor * other).abs() <= ROUND_OFF * own;
        let is_alike = |(own, other): (&Term, &Term)| match own.effect.acts {
            Acts::Shared(_) => own.is_like(other) && is_scaled(own.size, other.size),
            Acts::Neighbours => own.is_like(other) && own.size == other.size,
            Acts::Given => false,
            // What these change stands in sigma.
            Acts::Scales | Acts::Weighs | Acts::Rounds | Acts::Shows(_) | Acts::Times(_) => own.is_like(other),
        };
        self.terms.len() == other.terms.len()
            && self.sigma.iter().zip(other.sigma.iter()).all(|(own, other)| is_scaled(*own, *other))
            && self.terms.iter().zip(&other.terms).all(is_alike)
    }

    /// The same noise, what every row has to itself larger by a factor; what rows share stays.
    #[must_use]
    fn levelled(&self, factor: f64, measurements: &Measurements) -> Self {
        let own = self.own.map(|s| (factor * s).max(1e-15));
        Self { own, ..self.clone() }.with(self.terms.clone(), measurements)
    }

    /// All of its terms but one.
    pub fn terms_but(&self, number: usize) -> Vec<Term> {
        let others = self.terms.iter().enumerate().filter(|(i, _)| *i != number);
        others.map(|(_, term)| term.clone()).collect()
    }

    /// The same noise with another size of one term.
    #[must_use]
    pub fn resized(&self, number: usize, size: f64, measurements: &Measurements) -> Self {
        let mut terms = self.terms.clone();
        terms[number].size = size;
        self.with(terms, measurements)
    }

    /// Number of directions that terms leave free, each of which costs a degree of freedom.
    pub fn free_directions(&self) -> usize {
        self.shared.as_ref().map_or(0, |shared| shared.free())
    }

    /// Whether rows share any of it.
    pub fn is_shared(&self) -> bool {
        self.shared.is_some()
    }

    /// Degrees of freedom that these directions cost the means of groups of rows: the trace of their projection
    /// there.
    pub fn free_between(&self, group: &[usize]) -> f64 {
        self.shared.as_ref().map_or(0.0, |shared| shared.free_between(group))
    }

    /// Whitens values of every row (SI): divided by the standard uncertainties and freed of what the rows
    /// share, they are independent with variance 1 if they are noise.
    pub fn whiten(&self, values: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let mut own: Vec<f64> = values.into_iter().zip(self.sigma.iter()).map(|(v, s)| v / s).collect();
        if let Some(shared) = &self.shared {
            shared.whiten(&mut own);
        }
        own
    }

    /// Most probable contribution of each term to every row, SI, in the order of the terms: zeros, steps, drifts.
    pub fn shares(&self, residuals: &[f64]) -> Vec<Vec<f64>> {
        let mut of_terms = vec![vec![0.0; residuals.len()]; self.terms.len()];
        if let Some(shared) = &self.shared {
            for (term, column) in shared.amplitudes(residuals, &self.sigma) {
                column.into_iter().for_each(|(row, v)| of_terms[term][row] += v);
            }
        }
        of_terms
    }

    /// Residuals without what the terms most probably add, SI.
    pub fn unshared<'a>(&self, residuals: &'a [f64]) -> Cow<'a, [f64]> {
        if self.shared.is_none() {
            return residuals.into();
        }
        let mut left = residuals.to_vec();
        for share in self.shares(residuals) {
            left.iter_mut().zip(share).for_each(|(l, s)| *l -= s);
        }
        left.into()
    }

    /// ln det V, with V the covariance of all rows in SI.
    pub fn log_determinant(&self) -> f64 {
        let own: f64 = self.sigma.iter().map(|s| 2.0 * s.ln()).sum();
        own + self.shared.as_ref().map_or(0.0, |s| s.log_determinant)
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::process::Rows;

    /// Rows of the process `turning` whose first coordinate has these values.
    pub fn measured(values: &[f64]) -> Measurements {
        let process = crate::processes::ALL[0];
        let mut columns = vec![Values::shared(f64::NAN, values.len()); process.coordinates().len()];
        columns[0] = values.to_vec().into();
        Measurements::planned(process, "rows", Rows { columns, observable: Values::shared(0, values.len()) })
    }

    /// |W·v|² and ln det V for rows of standard uncertainty 1.
    pub fn whitened_square(measurements: &Measurements, terms: &[Term], values: &[f64]) -> (f64, f64) {
        let noise = Noise::independent(vec![1.0; values.len()], NoiseSource::Column).with(terms.to_vec(), measurements);
        (noise.whiten(values.iter().copied()).iter().map(|v| v * v).sum(), noise.log_determinant())
    }

    #[test]
    fn whitening_is_the_inverse_of_the_covariance() {
        // Two groupings that cross, a step and neighbours together, against the dense inverse.
        let measurements = measured(&[1.0, 2.0, 1.0, 2.0, 3.0, 1.0, 3.0]);
        let n = measurements.len();
        let group = Term { by: vec![0], size: 1.7, ..Term::new(&effects::ZERO_SHIFT) };
        let step = Term { rows: vec![4], size: 0.8, ..Term::new(&effects::JUMP) };
        let neighbours = Term { size: 1.5, ..Term::new(&effects::CORRELATED_NOISE) };
        let sigma: Vec<f64> = (0..n).map(|i| 0.5 + 0.1 * i as f64).collect();
        let mut dense =
            nalgebra::DMatrix::from_fn(n, n, |i, j| sigma[i] * sigma[j] * (-(i.abs_diff(j) as f64) / 1.5).exp());
        for i in 0..n {
            for j in 0..n {
                let same = measurements.rows.columns[0][i] == measurements.rows.columns[0][j];
                dense[(i, j)] += if same { 1.7 * 1.7 } else { 0.0 } + if i >= 4 && j >= 4 { 0.64 } else { 0.0 };
            }
        }
        let noise = Noise::independent(sigma, NoiseSource::Column).with(vec![group, step, neighbours], &measurements);
        let values: Vec<f64> = (0..n).map(|i| (1.3 * i as f64).sin()).collect();
        let square: f64 = noise.whiten(values.iter().copied()).iter().map(|v| v * v).sum();
        let v = nalgebra::DVector::from_vec(values);
        let exact = v.dot(&dense.clone().lu().solve(&v).unwrap());
        assert!((square - exact).abs() < 1e-10 * exact, "{square} {exact}");
        assert!((noise.log_determinant() - dense.determinant().ln()).abs() < 1e-10);
    }

    #[test]
    fn a_multiple_whitens_to_a_multiple_and_nothing_else_counts_as_one() {
        let measurements = measured(&[1.0, 2.0, 1.0, 2.0, 3.0]);
        let group = |size| Term { by: vec![0], size, ..Term::new(&effects::ZERO_SHIFT) };
        let neighbours = |size| Term { size, ..Term::new(&effects::CORRELATED_NOISE) };
        let of = |level: f64, terms: Vec<Term>| {
            let sigma: Values = (0..5).map(|i| level * (1.0 + 0.1 * f64::from(i))).collect();
            Noise::independent(sigma, NoiseSource::Estimated).with(terms, &measurements)
        };
        let noise = of(1.0, vec![group(1.7), neighbours(1.5)]);
        let values = [0.3, -1.0, 0.7, 0.2, -0.4];
        for multiple in [noise.times(2.5, &measurements), of(2.5, vec![group(4.25), neighbours(1.5)])] {
            assert!(multiple.is_a_multiple_of(&noise) && noise.is_a_multiple_of(&multiple));
            for (own, other) in multiple.whiten(values).iter().zip(noise.whiten(values)) {
                assert!((2.5 * own - other).abs() < 1e-12, "{own} {other}");
            }
        }
        let others = [
            of(2.5, vec![group(1.7), neighbours(1.5)]),
            of(2.5, vec![group(4.25), neighbours(3.0)]),
            of(2.5, vec![group(4.25)]),
            of(2.5, vec![neighbours(1.5), group(4.25)]),
            Noise::independent(vec![1.0; 5], NoiseSource::Estimated).with(noise.terms.clone(), &measurements),
        ];
        assert!(others.iter().all(|other| !other.is_a_multiple_of(&noise)));
    }
}
