//! What is minimised: χ² of the rows and of the priors, as a function of the search variables.

use nalgebra::{DMatrix, DVector};

use super::axis::Axis;
use crate::compare::{Noise, NoiseSource};
use crate::input::Parameter;
use crate::measure::Measurements;
use crate::model::Model;
use crate::process::{self, Active, Description, Failure, Holds, Rows};
use crate::units::{Knowledge, Quantity};

/// χ² as a function of the search variables: what the model does not know exactly, and every parameter of effects that are added to it
/// for a trial.
#[derive(Clone)]
pub struct Objective<'a> {
    /// The model as it is written.
    pub model: &'a Model,
    /// What it is fitted to.
    pub measurements: &'a Measurements,
    /// Effects that the model does not have, on trial.
    pub added: Vec<&'static Description>,
    /// The model's own parameters, then those of the added effects.
    pub parameters: Vec<Parameter>,
    /// One per parameter.
    pub axes: Vec<Axis>,
    /// By which rows are weighed.
    pub noise: Noise,
    /// Evaluations of the model so far.
    pub evaluations: usize,
    /// Those of them that gave no prediction.
    pub failures: usize,
}

/// A point of the search, as a rule a minimum.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Search variables.
    pub position: DVector<f64>,
    /// Of every row, SI.
    pub predicted: Vec<f64>,
    /// Of rows and priors.
    pub chi2: f64,
}

impl<'a> Objective<'a> {
    /// Weighs rows by their uncertainty; without one, by a hundredth of their scatter until another [`Noise`] is set, so that priors
    /// count, but little.
    ///
    /// # Errors
    /// The data are fewer than the free parameters.
    pub fn new(model: &'a Model, measurements: &'a Measurements) -> Result<Self, Failure> {
        let mut axes: Vec<Axis> = model.parameters.iter().map(|p| Axis::new(p, model.catalogue(&p.path))).collect();
        for (axis, parameter) in axes.iter_mut().zip(&model.parameters) {
            if parameter.quantity.value.is_nan() && model.is_written(&parameter.path) {
                let starts = starts_beside(model, measurements, parameter);
                axis.starts = if starts.is_empty() { std::mem::take(&mut axis.starts) } else { starts };
            }
        }
        let free = axes.iter().filter(|a| a.prior.is_none()).count();
        if measurements.len() < free + 1 + measurements.blind.len() {
            let circle = match measurements.blind.len() {
                0 => String::new(),
                blind => format!(" beside {blind} directions that the way of measuring takes out"),
            };
            let message = format!("{} rows cannot fix {free} free parameters{circle}", measurements.len());
            let help = "measure more, or give some of them a value with `+-`".into();
            return Err(Failure { message, help });
        }
        let noise = match &measurements.uncertainty {
            Some(sigma) => Noise { sigma: sigma.clone(), source: NoiseSource::Column },
            None => {
                let sigma: Vec<f64> =
                    measurements.rows_by_observable().iter().map(|r| scatter(measurements, r)).collect();
                Noise::alike(
                    measurements,
                    &sigma.iter().map(|s| (0.01 * s).max(1e-12)).collect::<Vec<_>>(),
                    NoiseSource::Estimated,
                )
            }
        };
        Ok(Self {
            model,
            measurements,
            added: Vec::new(),
            parameters: model.parameters.clone(),
            axes,
            noise,
            evaluations: 0,
            failures: 0,
        })
    }

    /// The same with one more effect on trial, each of its parameters free.
    #[must_use]
    pub fn with(&self, effect: &'static Description) -> Self {
        let mut more = self.clone();
        for entry in effect.parameters {
            more.parameters.push(Parameter {
                path: format!("effects.{}.{}", effect.name, entry.name),
                kind: entry.kind,
                quantity: Quantity { value: entry.kind.to_si(entry.example()), knowledge: Knowledge::Free },
                bounds: entry.bounds,
                span: None,
            });
            more.axes.push(Axis::on_trial(entry, self.extent(entry)));
        }
        more.added.push(effect);
        more
    }

    /// Where along its coordinate a place has been measured, or can be felt from, SI.
    fn extent(&self, entry: &process::Parameter) -> Option<(f64, f64)> {
        if let Some(reach) = entry.along.and_then(|along| self.model.system.reach(along)) {
            return Some(reach);
        }
        let coordinates = self.model.process.coordinates();
        let column = coordinates.iter().position(|c| Some(c.name) == entry.along)?;
        let values = || self.measurements.rows.columns[column].iter().copied().filter(|v| v.is_finite());
        let (low, high) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
        (low < high).then_some((low, high))
    }

    /// The catalogue's entry of a parameter, if it belongs to an effect.
    pub fn catalogue(&self, parameter: usize) -> Option<&'static process::Parameter> {
        let path = &self.parameters[parameter].path;
        let of_added = || {
            let (effect, name) = path.strip_prefix("effects.")?.split_once('.')?;
            let description = self.added.iter().find(|d| d.name == effect)?;
            description.parameters.iter().find(|p| p.name == name)
        };
        self.model.catalogue(path).or_else(of_added)
    }

    /// How many parameters have a prior.
    pub fn priors(&self) -> usize {
        self.axes.iter().filter(|a| a.prior.is_some()).count()
    }

    /// Rows and priors less parameters and directions to which the measurement is blind.
    pub fn freedom(&self) -> f64 {
        self.measurements.freedom() - (self.axes.len() - self.priors()) as f64
    }

    /// χ² of the priors alone.
    pub fn pull(&self, position: &DVector<f64>) -> f64 {
        let pull = |(axis, s): (&Axis, &f64)| axis.prior.map(|(value, std)| ((value - axis.value(*s)) / std).powi(2));
        self.axes.iter().zip(position.iter()).filter_map(pull).sum()
    }

    /// A position with every roughly known parameter at the value that is written.
    pub fn as_written(&self, position: &DVector<f64>) -> DVector<f64> {
        let written = |(axis, s): (&Axis, &f64)| axis.prior.map_or(*s, |(value, _)| axis.position(value));
        DVector::from_iterator(position.len(), self.axes.iter().zip(position.iter()).map(written))
    }

    /// σ from what a solution leaves: all rows by one factor. How the observables of a file compare, their neighbouring rows tell better than what
    /// a wrong model leaves in each.
    pub fn left_over(&self, solution: &Solution) -> Noise {
        let rows = self.measurements.observed.iter().zip(&solution.predicted).zip(&self.noise.sigma);
        let square: f64 = rows.map(|((y, p), s)| ((y - p) / s).powi(2)).sum();
        let factor = (square / self.freedom().max(1.0)).sqrt();
        let sigma = self.noise.sigma.iter().map(|s| (factor * s).max(1e-15));
        Noise { sigma: sigma.collect(), source: NoiseSource::Estimated }
    }

    /// The values of all parameters, SI.
    pub fn values(&self, position: &DVector<f64>) -> Vec<f64> {
        self.axes.iter().zip(position.iter()).map(|(a, s)| a.value(*s)).collect()
    }

    /// The prediction of every measured row, if the model can be computed there.
    pub fn predict(&mut self, position: &DVector<f64>) -> Option<Vec<f64>> {
        self.predict_rows(position, &self.measurements.rows)
    }

    /// The same of any rows.
    pub fn predict_rows(&mut self, position: &DVector<f64>, rows: &Rows) -> Option<Vec<f64>> {
        self.evaluations += 1;
        let values = self.values(position);
        let (own, mut rest) = values.split_at(self.model.parameters.len());
        let active = |description: &&'static Description| {
            let (values, others) = rest.split_at(description.parameters.len());
            rest = others;
            Active { description, values: values.to_vec(), written: None }
        };
        let added: Vec<Active> = self.added.iter().map(active).collect();
        let observed = self.model.job_with(own, &added).and_then(|job| job.observe(rows));
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
            let (low, high) = self.around(position, i);
            let mut at = |s: f64| {
                let mut moved = position.clone();
                moved[i] = s;
                self.predict(&moved).map(|p| self.residuals(&moved, &p))
            };
            let column = (at(high)? - at(low)?) / (high - low);
            jacobian.set_column(i, &column);
        }
        Some(jacobian)
    }

    /// Derivatives of the prediction of any rows, SI per unit of the search variables.
    pub fn sensitivities(&mut self, position: &DVector<f64>, rows: &Rows) -> Option<DMatrix<f64>> {
        let mut all = DMatrix::zeros(rows.len(), self.axes.len());
        for i in 0..self.axes.len() {
            let (low, high) = self.around(position, i);
            let mut at = |s: f64| {
                let mut moved = position.clone();
                moved[i] = s;
                self.predict_rows(&moved, rows).map(DVector::from_vec)
            };
            all.set_column(i, &((at(high)? - at(low)?) / (high - low)));
        }
        Some(all)
    }

    /// Two search variables close by, for a central difference; one-sided at a bound.
    fn around(&self, position: &DVector<f64>, i: usize) -> (f64, f64) {
        let axis = &self.axes[i];
        let step = 1e-4 * axis.unit.max(1e-3 * position[i].abs());
        ((position[i] - step).max(axis.low), (position[i] + step).min(axis.high))
    }

    /// Covariance of the search variables, (JᵀJ)⁻¹; a direction that the data do not see at all gets a huge variance.
    pub fn covariance(&mut self, solution: &Solution) -> Result<DMatrix<f64>, Failure> {
        let jacobian = self.jacobian(&solution.position).ok_or_else(|| Failure {
            message: "the model cannot be computed beside the best values".into(),
            help: "check bounds and values".into(),
        })?;
        let n = self.axes.len();
        if n == 0 {
            return Ok(DMatrix::zeros(0, 0));
        }
        let scale = DVector::from_iterator(n, self.axes.iter().map(|a| a.unit));
        let scaled = DMatrix::from_fn(jacobian.nrows(), n, |r, c| jacobian[(r, c)] * scale[c]);
        let eigen = (scaled.transpose() * scaled).symmetric_eigen();
        let floor = (1e-14 * eigen.eigenvalues.max()).max(f64::MIN_POSITIVE);
        let inverse = DMatrix::from_diagonal(&eigen.eigenvalues.map(|v| 1.0 / v.max(floor)));
        let inverse = &eigen.eigenvectors * inverse * eigen.eigenvectors.transpose();
        Ok(DMatrix::from_fn(n, n, |r, c| inverse[(r, c)] * scale[r] * scale[c]))
    }
}

/// Standard deviation of what some rows observed.
fn scatter(measurements: &Measurements, rows: &[usize]) -> f64 {
    let observed = || rows.iter().map(|row| measurements.observed[*row]);
    let mean = observed().sum::<f64>() / rows.len() as f64;
    (observed().map(|y| (y - mean).powi(2)).sum::<f64>() / rows.len() as f64).sqrt()
}

/// Where to look for a parameter of a written effect that shapes it: at parts of the extent of the first coordinate that is measured in its dimension, for
/// a length of waves or a time constant, and at places along it.
fn starts_beside(model: &Model, measurements: &Measurements, parameter: &Parameter) -> Vec<f64> {
    /// Of each sort.
    const STARTS: usize = 40;
    let dimension = parameter.kind.canonical().dimension;
    let rows = model.system.resolved(&measurements.rows);
    let coordinates = model.process.coordinates().iter().zip(&rows.columns);
    let mut extents = coordinates
        .filter(|(c, _)| process::written::dimension(c.holds) == dimension && matches!(c.holds, Holds::Quantity(_)))
        .map(|(_, values)| {
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            (low, values.iter().copied().fold(f64::NEG_INFINITY, f64::max))
        });
    let Some((low, high)) = extents.find(|(low, high)| high > low) else { return Vec::new() };
    let part = |i: usize| (i as f64 + 0.5) / STARTS as f64;
    // The shortest wave that a few dozen places resolve, and twice the whole.
    let waves = (0..STARTS).map(|i| (high - low) * 0.04 * 50f64.powf(part(i)));
    let places = (0..STARTS).map(|i| low + (high - low) * part(i));
    waves.chain(places).collect()
}
