//! What is minimised: χ² of the rows and of the priors, as a function of the search variables.

use nalgebra::{DMatrix, DVector};

use super::Estimate;
use super::axis::Axis;
use super::intervals::Interval;
use super::least_squares::{Solution, minimise};
use crate::compare::{Noise, NoiseSource};
use crate::measure::Measurements;
use crate::model::Model;
use crate::process::Failure;

/// A parameter moves the prediction so little that the data cannot see it: less than this many standard deviations, all rows
/// together, over the whole of its usual size.
const UNSEEN: f64 = 0.3;
/// A prior is hardly sharpened by the data when its uncertainty stays above this part.
const UNSHARPENED: f64 = 0.95;

pub struct Objective<'a> {
    model: &'a Model,
    measurements: &'a Measurements,
    pub axes: Vec<Axis>,
    pub noise: Noise,
    pub evaluations: usize,
    pub failures: usize,
}

impl<'a> Objective<'a> {
    /// Weighs rows by their uncertainty; without one, by 1 until [`Self::weigh`].
    pub fn new(model: &'a Model, measurements: &'a Measurements) -> Result<Self, Failure> {
        let fail = |message: String, help: &str| Err(Failure { message, help: help.into() });
        if model.parameters.is_empty() {
            return fail(
                "the model has nothing to fit".into(),
                "mark what is not exactly known: \"60 +- 15 N/um\" or \"? N/um\"",
            );
        }
        let axes: Vec<Axis> = model.parameters.iter().map(|p| Axis::new(p, model.catalogue(&p.path))).collect();
        let free = axes.iter().filter(|a| a.prior.is_none()).count();
        if measurements.len() < free + 1 {
            let message = format!("{} rows cannot fix {free} free parameters", measurements.len());
            return fail(message, "measure more, or give some of them a value with `+-`");
        }
        let sigma = measurements.uncertainty.clone().unwrap_or_else(|| {
            let mean = measurements.observed.iter().sum::<f64>() / measurements.len() as f64;
            let square = measurements.observed.iter().map(|y| (y - mean).powi(2)).sum::<f64>();
            // Without a noise yet, rows weigh as if a hundredth of their scatter were noise: priors count, but little.
            vec![(0.01 * (square / measurements.len() as f64).sqrt()).max(1e-12); measurements.len()]
        });
        let source = if measurements.uncertainty.is_some() { NoiseSource::Column } else { NoiseSource::Estimated };
        Ok(Self { model, measurements, axes, noise: Noise { sigma, source }, evaluations: 0, failures: 0 })
    }

    pub fn weigh(&mut self, noise: &Noise) {
        self.noise = noise.clone();
    }

    pub fn priors(&self) -> usize {
        self.axes.iter().filter(|a| a.prior.is_some()).count()
    }

    /// σ from what a solution leaves, all rows alike.
    pub fn left_over(&self, solution: &Solution) -> Noise {
        let square: f64 =
            self.measurements.observed.iter().zip(&solution.predicted).map(|(y, p)| (y - p).powi(2)).sum();
        let freedom = (self.measurements.len() as f64 - (self.axes.len() - self.priors()) as f64).max(1.0);
        let sigma = (square / freedom).sqrt().max(1e-15);
        Noise { sigma: vec![sigma; self.measurements.len()], source: NoiseSource::Estimated }
    }

    /// The prediction of every row, if the model can be computed there.
    pub fn predict(&mut self, position: &DVector<f64>) -> Option<Vec<f64>> {
        self.evaluations += 1;
        let values: Vec<f64> = self.axes.iter().zip(position.iter()).map(|(a, s)| a.value(*s)).collect();
        let observed = self.model.job_at(&values).and_then(|job| job.observe(&self.measurements.rows));
        let predicted = observed.ok().filter(|p| p.iter().all(|v| v.is_finite()));
        self.failures += usize::from(predicted.is_none());
        predicted
    }

    /// Standardised residuals of rows, then of priors.
    pub fn residuals(&self, position: &DVector<f64>, predicted: &[f64]) -> DVector<f64> {
        let rows =
            self.measurements.observed.iter().zip(predicted).zip(&self.noise.sigma).map(|((y, p), s)| (y - p) / s);
        let prior = |(axis, s): (&Axis, &f64)| axis.prior.map(|(value, std)| (value - axis.value(*s)) / std);
        DVector::from_vec(rows.chain(self.axes.iter().zip(position.iter()).filter_map(prior)).collect())
    }

    /// Derivatives of the residuals by central differences, one-sided at a bound.
    pub fn jacobian(&mut self, position: &DVector<f64>) -> Option<DMatrix<f64>> {
        let count = self.measurements.len() + self.priors();
        let mut jacobian = DMatrix::zeros(count, self.axes.len());
        for i in 0..self.axes.len() {
            let axis = &self.axes[i];
            let step = 1e-4 * axis.unit.max(1e-3 * position[i].abs());
            let ends = [(position[i] - step).max(axis.low), (position[i] + step).min(axis.high)];
            let mut at = |s: f64| {
                let mut moved = position.clone();
                moved[i] = s;
                self.predict(&moved).map(|p| self.residuals(&moved, &p))
            };
            let column = (at(ends[1])? - at(ends[0])?) / (ends[1] - ends[0]);
            jacobian.set_column(i, &column);
        }
        Some(jacobian)
    }

    /// The minimum near a position.
    pub fn solve(&mut self, start: &DVector<f64>) -> Result<Solution, Failure> {
        minimise(self, start, &[], 60).ok_or_else(|| Failure {
            message: "the model cannot be computed where the fit begins".into(),
            help: "give the parameters values from which `fem run` works".into(),
        })
    }

    /// Covariance of the search variables, (JᵀJ)⁻¹; a direction that the data do not see at all gets a huge variance.
    pub fn covariance(&mut self, solution: &Solution) -> Result<DMatrix<f64>, Failure> {
        let jacobian = self.jacobian(&solution.position).ok_or_else(|| Failure {
            message: "the model cannot be computed beside the best values".into(),
            help: "check bounds and values".into(),
        })?;
        let n = self.axes.len();
        let scale = DVector::from_iterator(n, self.axes.iter().map(|a| a.unit));
        let scaled = DMatrix::from_fn(jacobian.nrows(), n, |r, c| jacobian[(r, c)] * scale[c]);
        let eigen = (scaled.transpose() * scaled).symmetric_eigen();
        let floor = (1e-14 * eigen.eigenvalues.max()).max(f64::MIN_POSITIVE);
        let inverse = DMatrix::from_diagonal(&eigen.eigenvalues.map(|v| 1.0 / v.max(floor)));
        let inverse = &eigen.eigenvectors * inverse * eigen.eigenvectors.transpose();
        Ok(DMatrix::from_fn(n, n, |r, c| inverse[(r, c)] * scale[r] * scale[c]))
    }

    /// The parameters as the user sees them, with warnings.
    pub fn estimates(&self, solution: &Solution, covariance: &DMatrix<f64>, intervals: Vec<Interval>) -> Vec<Estimate> {
        let estimate = |(i, interval): (usize, Interval)| {
            let (axis, parameter) = (&self.axes[i], &self.model.parameters[i]);
            let position = solution.position[i];
            let std = covariance[(i, i)].sqrt() * axis.rate(position);
            let mut warnings = Vec::new();
            let at_bound = position <= axis.low || position >= axis.high;
            if at_bound {
                warnings.push("stands at its bound".to_string());
            }
            match axis.prior {
                Some((_, prior)) if std > UNSHARPENED * prior => {
                    warnings.push("the data hardly add to what was known".into());
                }
                None if !at_bound && covariance[(i, i)].sqrt() * UNSEEN > axis.unit => {
                    warnings.push("the data cannot see it".into());
                }
                _ => {}
            }
            if let Some(entry) = self.model.catalogue(&parameter.path) {
                let shown = entry.kind.from_si(axis.value(position));
                if !at_bound && !(entry.range.0..=entry.range.1).contains(&shown) {
                    warnings.push(format!(
                        "outside what is plausible, {} to {} {}",
                        entry.range.0, entry.range.1, entry.kind.unit
                    ));
                }
            }
            Estimate { parameter: parameter.clone(), value: axis.value(position), std, interval, warnings }
        };
        intervals.into_iter().enumerate().map(estimate).collect()
    }
}
