//! Estimating what a model does not know exactly: bounded nonlinear least squares with priors, and intervals from the profile of χ².

mod axis;
mod estimates;
mod intervals;
mod least_squares;
mod objective;
mod starts;
mod write;

pub use axis::Axis;
pub use intervals::{Interval, Settled, settle};
pub use least_squares::{Patience, minimise};
pub use objective::{Objective, Solution};
pub use starts::best;
pub use write::{fitted_before, fitted_text, uncertain};

use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

use crate::compare::{Noise, NoiseSource, SIGNIFICANCE, rms};
use crate::input::Parameter;
use crate::measure::{Measurements, Repeats, repeats};
use crate::model::Model;
use crate::process::Failure;

/// Two parameters this strongly correlated say nothing apart.
const CORRELATED: f64 = 0.95;

/// A model fitted to measurements. SI units.
#[derive(Clone, Debug)]
pub struct Fit {
    /// One per parameter that was not exactly known, in the order of the model.
    pub estimates: Vec<Estimate>,
    /// Prediction of every row with the fitted values.
    pub predicted: Vec<f64>,
    /// The noise by which rows were weighed.
    pub noise: Noise,
    /// Root mean square residual of the fitted model, in standard uncertainties where the file has several observables.
    pub rms: f64,
    /// χ² of rows and priors over ν = rows + priors − parameters; lack of fit over pure error with repeats.
    pub misfit: f64,
    /// How often chance alone gives a larger misfit; `None` where the noise is only estimated.
    pub p_value: Option<f64>,
    /// Pairs of parameters (by position) with their correlation, where it is strong.
    pub correlated: Vec<(usize, usize, f64)>,
    /// Trial values at which the model could not be computed.
    pub failures: usize,
    /// Evaluations of the model.
    pub evaluations: usize,
}

/// A fitted parameter. SI units.
#[derive(Clone, Debug)]
pub struct Estimate {
    /// What was fitted.
    pub parameter: Parameter,
    /// Best value.
    pub value: f64,
    /// Standard uncertainty from the curvature of χ².
    pub std: f64,
    /// 95 % interval from its profile; an end is open where the data do not close it.
    pub interval: Interval,
    /// What the user should know.
    pub warnings: Vec<String>,
}

impl Fit {
    /// By what standard uncertainties are enlarged when values are handed on, √(χ²/ν) where the noise does not explain what is left
    /// (Birge 1932): what is missing has bent them, and as priors they must not hold on to that.
    pub fn doubt(&self) -> f64 {
        if self.p_value.is_some_and(|p| p < SIGNIFICANCE) { self.misfit.max(1.0).sqrt() } else { 1.0 }
    }
}

impl Estimate {
    /// Whether the data close the interval on both sides.
    pub fn is_closed(&self) -> bool {
        self.interval.low.is_some() && self.interval.high.is_some()
    }
}

/// Fits what the model marks `+-` (with its prior) and `?` (free).
///
/// # Errors
/// Nothing is to be fitted, the data are fewer than the free parameters, or the model cannot be computed at all.
pub fn fit(model: &Model, measurements: &Measurements) -> Result<Fit, Failure> {
    if model.parameters.is_empty() {
        return Err(Failure {
            message: "the model has nothing to fit".into(),
            help: "mark what is not exactly known: \"60 +- 15 N/um\" or \"? N/um\"".into(),
        });
    }
    let measurements = &*measurements.seen_by(&*model.system);
    let repeats = repeats(measurements, model.process.coordinates());
    let mut objective = Objective::new(model, measurements)?;
    let mut solution = starts::best(&mut objective)?;
    let known = measurements.uncertainty.is_some();
    if !known {
        // The noise is judged by what the best model leaves, and priors are weighed against it: twice settles both.
        for _ in 0..2 {
            objective.noise = Noise::of(measurements, &repeats, &residuals(measurements, &solution.predicted));
            if objective.noise.source == NoiseSource::Estimated {
                objective.noise = objective.left_over(&solution);
            }
            solution = least_squares::solve(&mut objective, &solution.position)?;
        }
    }
    let settled = settle(&mut objective, solution)?;
    Ok(report(&objective, settled, &repeats))
}

fn residuals(measurements: &Measurements, predicted: &[f64]) -> Vec<f64> {
    measurements.observed.iter().zip(predicted).map(|(y, p)| y - p).collect()
}

/// Everything that is said of a minimum.
pub fn report(objective: &Objective, settled: Settled, repeats: &Repeats) -> Fit {
    let Settled { solution, covariance, intervals } = settled;
    let residuals = residuals(objective.measurements, &solution.predicted);
    let (misfit, p_value) = judge(objective, &solution, repeats);
    let estimates = estimates::estimates(objective, &solution, &covariance, intervals);
    let rms = rms(&objective.measurements.together(&residuals, &objective.noise.sigma));
    let correlation = |i: usize, j: usize| covariance[(i, j)] / (covariance[(i, i)] * covariance[(j, j)]).sqrt();
    let pairs = (0..estimates.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    let strong = pairs.map(|(i, j)| (i, j, correlation(i, j))).filter(|(_, _, c)| c.abs() > CORRELATED);
    Fit {
        correlated: strong.collect(),
        estimates,
        predicted: solution.predicted,
        noise: objective.noise.clone(),
        rms,
        misfit,
        p_value,
        failures: objective.failures,
        evaluations: objective.evaluations,
    }
}

/// χ²/ν and how often chance alone gives more: for a known noise; lack of fit over pure error by F with repeats; without a p-value where the
/// noise is only estimated.
pub fn judge(objective: &Objective, solution: &Solution, repeats: &Repeats) -> (f64, Option<f64>) {
    let freedom = objective.freedom();
    match objective.noise.source {
        NoiseSource::Column => {
            let p = ChiSquared::new(freedom).ok().map(|d| d.sf(solution.chi2));
            (solution.chi2 / freedom, p)
        }
        NoiseSource::Repeats => {
            // In units of itself the scatter of the repeats is its degrees of freedom.
            let pure = repeats.freedom() as f64;
            let freedom = freedom - pure;
            let f = (solution.chi2 - pure).max(0.0) / freedom;
            (f, FisherSnedecor::new(freedom, repeats.yardstick()).ok().map(|d| d.sf(f)))
        }
        NoiseSource::Estimated => (solution.chi2 / freedom, None),
    }
}
