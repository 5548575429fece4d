//! Objective function: χ² of the rows and of the priors, as a function of the search variables.

use std::collections::HashSet;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{DMatrix, DVector};

use super::coarseness::Coarseness;
use super::search_variable::SearchVariable;
use super::steps::Steps;
use crate::input::Parameter;
use crate::measure::Measurements;
use crate::model::{Data, Model};
use crate::noise::{Noise, NoiseSource};
use crate::process::{self, Active, Description, Failure, ForwardModel, Holds, Rows};
use crate::units::{Knowledge, PERIOD, Quantity, TIME};

/// χ² as a function of the search variables: the parameters that the model does not know exactly, and every
/// parameter of candidate effects that are added to it.
#[derive(Clone)]
pub struct Objective<'a> {
    /// Measurements, with the model as it is written.
    pub data: &'a Data<'a>,
    /// Candidate effects that are added to the model.
    pub added: Vec<Description>,
    /// Parameters of the model, then those of the added effects.
    pub parameters: Vec<Parameter>,
    /// Search variable of each parameter.
    pub variables: Vec<SearchVariable>,
    /// Noise by which the rows are weighted.
    pub noise: Noise,
    /// By how much the usual sizes of candidate effects are beyond those of the catalogue.
    pub coarseness: Coarseness,
    /// Evaluations of the model so far, of this objective and of all that were made of it.
    pub trials: Arc<Trials>,
}

/// Counts evaluations of a model.
#[derive(Debug, Default)]
pub struct Trials {
    evaluations: AtomicUsize,
    failures: AtomicUsize,
}

impl Trials {
    /// Number of evaluations so far.
    pub fn evaluations(&self) -> usize {
        self.evaluations.load(Ordering::Relaxed)
    }

    /// Number of those that gave no prediction.
    pub fn failures(&self) -> usize {
        self.failures.load(Ordering::Relaxed)
    }
}

/// A point of the search, as a rule a minimum.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Values of the search variables.
    pub position: DVector<f64>,
    /// Prediction of every row, SI.
    pub predicted: Vec<f64>,
    /// χ² of rows and priors.
    pub chi2: f64,
    /// Slopes of the prediction there or close by, SI per unit of the search variables, if a search has made them.
    pub slopes: Option<Arc<DMatrix<f64>>>,
    /// Whether a search has come to rest by them.
    pub is_at_rest: bool,
}

impl<'a> Objective<'a> {
    /// Weights the rows by their uncertainty; without one, by a hundredth of their scatter until another
    /// [`Noise`] is set, so that priors count, but little.
    ///
    /// # Errors
    /// The data are fewer than the free parameters.
    pub fn new(data: &'a Data<'a>) -> Result<Self, Failure> {
        let model = data.model;
        let mut variables: Vec<SearchVariable> =
            model.parameters.iter().map(|p| SearchVariable::new(p, model.catalogue(&p.path))).collect();
        for (variable, parameter) in variables.iter_mut().zip(&model.parameters) {
            if !model.is_of_formula(&parameter.path) {
                continue;
            }
            if parameter.quantity.value.is_nan() {
                let starts = starts_beside(model, data, parameter);
                variable.starts = if starts.is_empty() { std::mem::take(&mut variable.starts) } else { starts };
            } else {
                // Whoever writes a law, and where its search begins, knows the valley.
                variable.is_surveyed = false;
            }
        }
        for (variable, parameter) in variables.iter_mut().zip(&model.parameters) {
            let Some(entry) = model.catalogue(&parameter.path) else { continue };
            if entry.is_step {
                *variable = variable.clone().stepping(steps(data, entry));
            } else if let Some(reach) = entry.along.as_ref().and_then(|along| model.system.reach(along)) {
                *variable = variable.clone().within(reach);
            }
        }
        let free = variables.iter().filter(|a| a.prior.is_none()).count();
        if data.len() < free + 1 + data.datum_directions.len() {
            let circle = match data.datum_directions.len() {
                0 => String::new(),
                blind => format!(" beside {blind} directions that the way of measuring takes out"),
            };
            let message = format!("{} rows cannot fix {free} free parameters{circle}", data.len());
            let help = "measure more, or give some of them a value with `+-`".into();
            return Err(Failure { message, help });
        }
        let noise = match &data.uncertainty {
            Some(sigma) => Noise::independent(sigma.clone(), NoiseSource::Column),
            None => {
                let sigma: Vec<f64> = data.rows_by_observable().iter().map(|r| scatter(data, r)).collect();
                Noise::alike(
                    data,
                    &sigma.iter().map(|s| (0.01 * s).max(1e-12)).collect::<Vec<_>>(),
                    NoiseSource::Estimated,
                )
            }
        };
        Ok(Self {
            data,
            added: Vec::new(),
            parameters: model.parameters.clone(),
            variables,
            noise,
            coarseness: Coarseness::default(),
            trials: Arc::default(),
        })
    }

    /// Adds a candidate effect, each of its parameters free.
    #[must_use]
    pub fn with(&self, effect: &Description) -> Self {
        let mut more = self.clone();
        for entry in &*effect.parameters {
            let entry = &self.coarseness.plausible(effect, entry);
            more.parameters.push(Parameter {
                path: effect.path(entry),
                kind: entry.kind,
                quantity: Quantity { value: entry.kind.to_si(entry.example()), knowledge: Knowledge::Free },
                bounds: entry.bounds,
                span: None,
                doubt: None,
            });
            let steps = if entry.is_step { steps(self.data, entry) } else { None };
            more.variables.push(SearchVariable::of_candidate(entry, self.extent(entry)).stepping(steps));
        }
        more.added.push(effect.clone());
        more
    }

    /// Extent, along its coordinate, of the places that were measured or can be felt, SI.
    fn extent(&self, entry: &process::Parameter) -> Option<(f64, f64)> {
        if entry.kind == PERIOD {
            let (shortest, longest) = (entry.kind.to_si(entry.range.0), entry.kind.to_si(entry.range.1));
            return self.only_span().filter(|span| (shortest..longest).contains(span)).map(|span| (shortest, span));
        }
        if let Some(reach) = entry.along.as_ref().and_then(|along| self.data.model.system.reach(along)) {
            return Some(reach);
        }
        let coordinates = self.data.model.process.coordinates();
        let column = coordinates.iter().position(|c| Some(&c.name) == entry.along.as_ref())?;
        let ends = |rows: &Rows| {
            let values = || rows.columns[column].iter().copied().filter(|v| v.is_finite());
            (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max))
        };
        let (low, high) = match ends(&self.data.rows) {
            (low, high) if low <= high => (low, high),
            // What the rows leave to the model, as the cutting path.
            _ => ends(&self.data.model.system.resolved(&self.data.rows)),
        };
        (low < high).then_some((low, high))
    }

    /// Span of the times where the rows differ in nothing else (s): of a longer wave a piece is seen, and any bow is a piece
    /// of some wave.
    pub fn only_span(&self) -> Option<f64> {
        let coordinates = self.data.model.process.coordinates();
        let span = |i: usize| {
            let column = &self.data.rows.columns[i];
            let ends = column.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
            ends.1 - ends.0
        };
        let varying: Vec<usize> = self.data.given.iter().copied().filter(|i| span(*i) > 0.0).collect();
        match varying[..] {
            [time] if coordinates[time].holds.kind() == Some(TIME) => Some(span(time)),
            _ => None,
        }
    }

    /// Catalogue entry of a parameter, if it belongs to an effect.
    pub fn catalogue(&self, parameter: usize) -> Option<&process::Parameter> {
        let path = &self.parameters[parameter].path;
        let of_added = || {
            let mut all = self.added.iter().flat_map(|d| d.parameters.iter().map(move |p| (d, p)));
            all.find(|(d, p)| d.path(p) == *path).map(|(_, p)| p)
        };
        self.data.model.catalogue(path).or_else(of_added)
    }

    /// Where a variable stands when its effect changes nothing: at its neutral value, and that of the change of an effect
    /// where the effect itself stands at a position.
    pub fn neutral_at(&self, variable: usize, position: &[f64]) -> f64 {
        let own = &self.variables[variable];
        self.unchanged(variable, position).map_or_else(|| own.neutral(), |value| own.position(value))
    }

    /// The value (SI) that a parameter of the change of an effect has in the effect itself; `None` where it is none, or the
    /// effect is not there.
    pub fn unchanged(&self, variable: usize, position: &[f64]) -> Option<f64> {
        let mut first = self.data.model.parameters.len();
        let owner = self.added.iter().find_map(|effect| {
            let number = variable.checked_sub(first)?;
            first += effect.parameters.len();
            effect.parameters.get(number).map(|parameter| (effect, parameter))
        });
        let (effect, parameter) = owner.filter(|(_, parameter)| !parameter.is_step)?;
        let changes = effect.changes.as_ref()?;
        let path = format!("{}.{changes}.{}", effect.table, parameter.name);
        let free = self.parameters.iter().position(|p| *p.path == *path).filter(|i| *i < position.len());
        free.map(|i| self.variables[i].value(position[i])).or_else(|| self.data.model.value(&path))
    }

    /// Number of parameters with a prior.
    pub fn priors(&self) -> usize {
        self.variables.iter().filter(|a| a.prior.is_some()).count()
    }

    /// Degrees of freedom: rows and priors less parameters and datum directions.
    pub fn freedom(&self) -> f64 {
        self.data.freedom() - self.noise.free_directions() as f64 - (self.variables.len() - self.priors()) as f64
    }

    /// Whether a prediction could fail: rows of different conditions, or that are predicted apart, are more than what is
    /// free. Rows that repeat each other leave degrees of freedom, but test nothing.
    pub fn is_tested(&self, predicted: &[f64]) -> bool {
        let free = self.data.len() as f64 - self.freedom();
        let is_enough = |count: usize| count as f64 >= free + 1.0;
        let repeats = self.data.repeats();
        let apart = || repeats.group.iter().zip(predicted).map(|(g, p)| (g, p.to_bits())).collect::<HashSet<_>>().len();
        is_enough(repeats.groups) || is_enough(apart())
    }

    /// χ² of the priors alone.
    pub fn prior_chi2(&self, position: &DVector<f64>) -> f64 {
        let prior_chi2 = |(variable, s): (&SearchVariable, &f64)| {
            variable.prior.map(|(value, std)| ((value - variable.value(*s)) / std).powi(2))
        };
        self.variables.iter().zip(position.iter()).filter_map(prior_chi2).sum()
    }

    /// Position with every parameter that has a prior at its prior value.
    pub fn as_written(&self, position: &DVector<f64>) -> DVector<f64> {
        let written =
            |(variable, s): (&SearchVariable, &f64)| variable.prior.map_or(*s, |(value, _)| variable.position(value));
        DVector::from_iterator(position.len(), self.variables.iter().zip(position.iter()).map(written))
    }

    /// Noise estimated from the residuals of a solution: the present σ of all rows times one factor. The
    /// ratio between observables stays, for neighbouring rows tell it better than the residuals of a wrong
    /// model.
    pub fn residual_noise(&self, solution: &Solution) -> Noise {
        let left = self.data.residuals(&solution.predicted);
        let square: f64 = self.noise.whiten(left).iter().map(|z| z * z).sum();
        let factor = (square / self.freedom().max(1.0)).sqrt();
        let mut noise = self.noise.times(factor, self.data);
        noise.source = NoiseSource::Estimated;
        noise
    }

    /// Values of all parameters, SI.
    pub fn values(&self, position: &DVector<f64>) -> Vec<f64> {
        self.variables.iter().zip(position.iter()).map(|(a, s)| a.value(*s)).collect()
    }

    /// The model with the effects that are added and all parameters there.
    ///
    /// # Errors
    /// The values make no model.
    pub fn forward(&self, position: &DVector<f64>) -> Result<Box<dyn ForwardModel>, Failure> {
        let values = self.values(position);
        let (own, mut rest) = values.split_at(self.data.model.parameters.len());
        let active = |description: &Description| {
            let (values, others) = rest.split_at(description.parameters.len());
            rest = others;
            description.with(values.to_vec())
        };
        let added: Vec<Active> = self.added.iter().map(active).collect();
        self.data.model.forward_with(own, &added)
    }

    /// The prediction and its χ² at a position, if the model can be computed there.
    pub fn evaluate(&self, position: DVector<f64>) -> Option<Solution> {
        let predicted = self.predict(&position)?;
        let chi2 = self.residuals(&position, &predicted).norm_squared();
        chi2.is_finite().then_some(())?;
        Some(Solution { position, predicted, chi2, slopes: None, is_at_rest: false })
    }

    /// Prediction of every measured row, if the model can be computed there.
    pub fn predict(&self, position: &DVector<f64>) -> Option<Vec<f64>> {
        self.predict_rows(position, &self.data.rows)
    }

    /// Prediction of any rows, if the model can be computed there.
    pub fn predict_rows(&self, position: &DVector<f64>, rows: &Rows) -> Option<Vec<f64>> {
        if self.data.progress.is_stopped() {
            return None;
        }
        self.trials.evaluations.fetch_add(1, Ordering::Relaxed);
        self.data.progress.evaluated();
        let observed = self.forward(position).and_then(|job| job.observe(rows));
        let predicted = observed.ok().filter(|p| p.iter().all(|v| v.is_finite()));
        self.trials.failures.fetch_add(usize::from(predicted.is_none()), Ordering::Relaxed);
        predicted
    }

    /// Standardised residuals of rows, then of priors.
    pub fn residuals(&self, position: &DVector<f64>, predicted: &[f64]) -> DVector<f64> {
        let rows = self.noise.whiten(self.data.residuals(predicted)).into_iter();
        let prior = |(variable, s): (&SearchVariable, &f64)| {
            variable.prior.map(|(value, std)| (value - variable.value(*s)) / std)
        };
        DVector::from_vec(rows.chain(self.variables.iter().zip(position.iter()).filter_map(prior)).collect())
    }

    /// Whitens a difference of predictions of all rows, SI; zeros stand where residuals hold the priors.
    pub fn whiten(&self, difference: impl IntoIterator<Item = f64>) -> DVector<f64> {
        let priors = std::iter::repeat_n(0.0, self.priors());
        DVector::from_vec(self.noise.whiten(difference).into_iter().chain(priors).collect())
    }

    /// Covariance of the search variables, (JᵀJ)⁻¹, from the Jacobian at a solution; a direction that the data do not
    /// see gets a huge variance.
    pub fn covariance(&self, jacobian: &DMatrix<f64>) -> DMatrix<f64> {
        let n = self.variables.len();
        if n == 0 {
            return DMatrix::zeros(0, 0);
        }
        let scale = DVector::from_iterator(n, self.variables.iter().map(|a| a.unit));
        let scaled = DMatrix::from_fn(jacobian.nrows(), n, |r, c| jacobian[(r, c)] * scale[c]);
        let eigen = (scaled.transpose() * scaled).symmetric_eigen();
        let floor = (1e-14 * eigen.eigenvalues.max()).max(f64::MIN_POSITIVE);
        let inverse = DMatrix::from_diagonal(&eigen.eigenvalues.map(|v| 1.0 / v.max(floor)));
        let inverse = &eigen.eigenvectors * inverse * eigen.eigenvectors.transpose();
        DMatrix::from_fn(n, n, |r, c| inverse[(r, c)] * scale[r] * scale[c])
    }
}

/// The measured numbers along the coordinate of a parameter in which the law is a step.
fn steps(data: &Data, entry: &process::Parameter) -> Option<Steps> {
    let column = data.model.process.coordinates().iter().position(|c| Some(&c.name) == entry.along.as_ref())?;
    Steps::new(data.rows.columns[column].iter().copied())
}

/// Standard deviation of the observed values of some rows.
fn scatter(measurements: &Measurements, rows: &[usize]) -> f64 {
    let observed = || rows.iter().map(|row| measurements.observed[*row]);
    let mean = observed().sum::<f64>() / rows.len() as f64;
    (observed().map(|y| (y - mean).powi(2)).sum::<f64>() / rows.len() as f64).sqrt()
}

/// Starting values of a nonlinear parameter of a formula effect: parts of the extent of the first coordinate
/// in its dimension, for a wavelength or a time constant, and places along it.
fn starts_beside(model: &Model, measurements: &Measurements, parameter: &Parameter) -> Vec<f64> {
    /// Starting values of each sort.
    const STARTS: usize = 40;
    let dimension = parameter.kind.canonical().dimension;
    let rows = model.system.resolved(&measurements.rows);
    let coordinates = model.process.coordinates().iter().zip(&rows.columns);
    let mut extents = coordinates
        .filter(|(c, _)| {
            process::formula_effect::dimension(&c.holds) == dimension && matches!(c.holds, Holds::Quantity(_))
        })
        .map(|(_, values)| {
            let low = values.iter().copied().fold(f64::INFINITY, f64::min);
            (low, values.iter().copied().fold(f64::NEG_INFINITY, f64::max))
        });
    let Some((low, high)) = extents.find(|(low, high)| high > low) else { return Vec::new() };
    let part = |i: usize| (i as f64 + 0.5) / STARTS as f64;
    // From the shortest wave that a few dozen places resolve to twice the whole extent.
    let waves = (0..STARTS).map(|i| (high - low) * 0.04 * 50f64.powf(part(i)));
    let places = (0..STARTS).map(|i| low + (high - low) * part(i));
    waves.chain(places).collect()
}
