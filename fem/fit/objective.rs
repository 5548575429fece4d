//! What is minimised: χ² of the rows and of the priors, as a function of the search variables.

use nalgebra::{DMatrix, DVector};

use super::axis::Axis;
use crate::compare::{Noise, NoiseSource};
use crate::measure::Measurements;
use crate::model::Model;
use crate::process::Failure;

/// χ² as a function of the search variables.
pub struct Objective<'a> {
    pub model: &'a Model,
    measurements: &'a Measurements,
    pub axes: Vec<Axis>,
    pub noise: Noise,
    pub evaluations: usize,
    pub failures: usize,
}

/// A minimum.
#[derive(Clone, Debug)]
pub struct Solution {
    pub position: DVector<f64>,
    pub predicted: Vec<f64>,
    pub chi2: f64,
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
}
