//! Estimates the parameters that a model does not know exactly: bounded nonlinear least squares with priors
//! (maximum a posteriori), and profile-likelihood intervals.

mod coarseness;
mod edits;
mod estimates;
mod growth;
mod intervals;
mod jacobian;
mod known;
pub(crate) mod least_squares;
mod objective;
mod search_variable;
mod settle;
mod sizes;
mod spreading;
pub(crate) mod starts;
mod steps;
mod told_together;
mod usual;

pub use coarseness::Coarseness;
pub use edits::{edits, five_digits, uncertain, uncertain_beside};
pub use estimates::Estimate;
pub use intervals::{Interval, ProfiledMinimum, profile_intervals};
pub use jacobian::Differences;
pub use known::Known;
pub use least_squares::{StoppingCriterion, minimise, resume};
pub use objective::{Objective, Solution, Trials};
pub use search_variable::SearchVariable;
pub use sizes::{EstimatedSize, size_estimate};
pub use starts::best;
pub use steps::MOST_STARTS;
pub use told_together::{Combination, is_idle};
pub use usual::Usual;

use std::borrow::Cow;

use nalgebra::DMatrix;

use crate::compare::{self, SIGNIFICANCE, rms};
use crate::measure::Repeats;
use crate::model::{Data, Model};
use crate::noise::{Noise, NoiseSource, Restricted};
use crate::process::Failure;

/// Correlation beyond which two parameters can hardly be told apart.
const CORRELATED: f64 = 0.95;

/// A model fitted to measurements. SI units.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Fit {
    /// Estimate of each parameter that was not exactly known, in the order of the model.
    pub estimates: Vec<Estimate>,
    /// Sizes of effects of the measurement that the model leaves unknown.
    #[doc(hidden)]
    pub sizes: Vec<EstimatedSize>,
    /// Prediction of every row with the fitted values.
    pub predicted: Vec<f64>,
    /// Noise that is told: that by which the rows were weighted, or, where it is only estimated, what neighbouring rows
    /// of the residuals tell.
    #[doc(hidden)]
    pub noise: Noise,
    /// Root mean square residual of the fitted model, SI; in standard uncertainties where the file has
    /// several observables.
    pub rms: f64,
    /// Reduced χ²: χ² of rows and priors over ν = rows + priors − parameters; lack of fit over pure error
    /// (F) with repeats.
    pub reduced_chi2: f64,
    /// Probability that chance alone gives a larger χ² (p-value); `None` where the noise is only estimated.
    pub p_value: Option<f64>,
    /// Whether the noise explains what is left, as a comparison of the fitted model will say; `None` where the rows cannot
    /// tell it.
    pub adequacy: Option<bool>,
    /// Pairs of parameters (by position) with their correlation, where it is strong.
    pub correlated: Vec<(usize, usize, f64)>,
    /// Pairs of parameters (by position) of which all rows tell one combination alone.
    #[doc(hidden)]
    pub told_together: Vec<(usize, usize, Combination)>,
    /// What is known of the values together, for whoever goes on with them.
    #[doc(hidden)]
    pub known: Known,
    /// Physical impossibilities that the fitted model's prediction implies, and a search that did not come to rest, in
    /// sentences.
    pub doubts: Vec<String>,
    /// Number of evaluations at which the model could not be computed.
    pub failures: usize,
    /// Number of evaluations of the model.
    pub evaluations: usize,
}

impl Fit {
    /// The estimates of what a model itself leaves open.
    pub fn of<'f>(&'f self, model: &'f Model) -> impl Iterator<Item = &'f Estimate> {
        self.estimates.iter().filter(|e| model.parameters.iter().any(|own| own.path == e.parameter.path))
    }

    /// Birge ratio (Birge 1932): √(χ²/ν) where the noise does not explain the residuals, else 1. Standard
    /// uncertainties are enlarged by it when values are handed on: a missing effect has biased them, and as
    /// priors they must not hold on to that.
    pub fn birge_ratio(&self) -> f64 {
        if self.p_value.is_some_and(|p| p < SIGNIFICANCE) { self.reduced_chi2.max(1.0).sqrt() } else { 1.0 }
    }
}

/// Whether a model leaves nothing open: no parameter, and no size of an effect of the measurement.
pub fn has_nothing_to_fit(model: &Model) -> bool {
    model.parameters.is_empty() && !model.measurement.iter().any(|term| model.is_unknown(term))
}

/// Fits the parameters that the model marks `+-` (with a prior) and `?` (free), and estimates the sizes of
/// effects of the measurement that it leaves unknown.
///
/// # Errors
/// There is nothing to fit, the data are fewer than the free parameters, or the model cannot be computed at
/// all.
pub fn fit(data: &Data) -> Result<Fit, Failure> {
    if has_nothing_to_fit(data.model) {
        return Err(Failure {
            message: "the model has nothing to fit".into(),
            help: "mark what is not exactly known: \"60 +- 15 N/um\" or \"? N/um\"".into(),
        });
    }
    // On a thread of the pool: one from outside would wait for it at every Jacobian.
    rayon::scope(|_| fitted(data))
}

fn fitted(data: &Data) -> Result<Fit, Failure> {
    let mut objective = Objective::new(data)?;
    let mut solution = starts::best(&mut objective)?;
    let known = data.uncertainty.is_some() && data.terms.is_empty();
    let mut within = data.repeats().clone();
    if !known {
        (solution, within) = settled(&mut objective, solution)?;
    }
    let settled = profile_intervals(&mut objective, solution)?;
    let fit = report(&objective, settled.clone(), &within);
    let mean = objective.mean(&settled.solution).unwrap_or_else(|| DMatrix::zeros(data.len(), 0));
    let residuals = data.residuals(&fit.predicted);
    let restricted = Restricted { measurements: data, residuals: &residuals, mean: &mean };
    Ok(Fit { sizes: sizes::estimated(data, &restricted, &objective.noise), ..fit })
}

/// A solution under the noise that it leaves itself, with the effects of the measurement that the model states, and the repeats
/// within the groups that these set apart: an estimated noise is that of all that is left, and what is roughly known is weighed
/// against it.
///
/// # Errors
/// The model cannot be computed.
pub fn settled(objective: &mut Objective, mut solution: Solution) -> Result<(Solution, Repeats), Failure> {
    /// Most rounds, and the ratio between two estimates of the noise from which it has settled.
    const ROUNDS: usize = 10;
    const SETTLED: f64 = 1.0001;
    let data = objective.data;
    let mut within = data.repeats().clone();
    for _ in 0..ROUNDS {
        let before = objective.noise.clone();
        let left = data.residuals(&solution.predicted);
        let mean = objective.mean(&solution).unwrap_or_else(|| DMatrix::zeros(data.len(), 0));
        (objective.noise, within) = Noise::stated(&data.terms, data, data.repeats(), &left, &mean);
        if objective.noise.source == NoiseSource::Estimated {
            objective.noise = objective.residual_noise(&solution);
        }
        solution = least_squares::solve(objective, &solution.position)?;
        if objective.noise.is_about(&before, SETTLED) {
            break;
        }
    }
    Ok((solution, within))
}

/// What is said of a search that has used up its steps.
const UNSETTLED: &str = "the search for the best values ended before it came to rest: the values may move on, \
                         where the data hardly tell them apart";

/// Makes the report of a minimum.
pub fn report(objective: &Objective, settled: ProfiledMinimum, repeats: &Repeats) -> Fit {
    let ProfiledMinimum { solution, covariance, intervals, profiles } = settled;
    let is_open: Vec<bool> = intervals.iter().map(Interval::is_open).collect();
    let told_together = told_together::pairs(objective, &solution, &is_open);
    let intervals = intervals.into_iter().zip(profiles).collect();
    let residuals = objective.data.residuals(&solution.predicted);
    let (reduced_chi2, p_value) = reduced_chi2(objective, &solution, repeats);
    let estimates = estimates::estimates(objective, &solution, &covariance, intervals, &told_together);
    let noise = told_noise(objective, &residuals).into_owned();
    let rms = rms(&objective.data.together(&residuals, &noise.sigma));
    let written = compare::judged(objective.data, &objective.noise.terms, solution.predicted.clone());
    let is_too_much = p_value.is_some_and(|p| p < SIGNIFICANCE);
    let correlation = |i: usize, j: usize| covariance[(i, j)] / (covariance[(i, i)] * covariance[(j, j)]).sqrt();
    let known = Known::of(objective, &solution, &covariance);
    let pairs = (0..estimates.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
    let strong = pairs.map(|(i, j)| (i, j, correlation(i, j))).filter(|(_, _, c)| c.abs() > CORRELATED);
    let doubts = objective.forward(&solution.position).and_then(|forward| forward.doubts(&objective.data.rows));
    let mut doubts = doubts.unwrap_or_default();
    if !solution.is_at_rest {
        doubts.push(UNSETTLED.into());
    }
    doubts.extend(compare::caution(objective.data, &noise, reduced_chi2));
    Fit {
        doubts,
        correlated: strong.collect(),
        told_together,
        known,
        estimates,
        sizes: Vec::new(),
        predicted: solution.predicted,
        noise,
        rms,
        reduced_chi2,
        p_value,
        adequacy: written.adequacy().map(|is_adequate| is_adequate && !is_too_much),
        failures: objective.trials.failures(),
        evaluations: objective.trials.evaluations(),
    }
}

/// Reduced χ² and its p-value, as a comparison has them, beside what the fit takes and knows.
pub fn reduced_chi2(objective: &Objective, solution: &Solution, repeats: &Repeats) -> (f64, Option<f64>) {
    let (data, noise) = (objective.data, &objective.noise);
    let residuals = data.residuals(&solution.predicted);
    let taken = data.len() as f64 - objective.freedom() - noise.free_directions() as f64;
    let told = told_noise(objective, &residuals);
    compare::reduced_chi2(data, (&residuals, &told), repeats, (taken, objective.prior_chi2(&solution.position)))
}

/// The noise by which residuals are told, as a comparison of the fitted model will: where it is only estimated, a fit weighs
/// by all that is left, and what is left may be more than noise.
pub fn told_noise<'o>(objective: &'o Objective, residuals: &[f64]) -> Cow<'o, Noise> {
    let (data, noise) = (objective.data, &objective.noise);
    // Beside terms the likelihood has found its level, and a comparison finds it so too.
    if noise.source == NoiseSource::Estimated && noise.terms.is_empty() {
        Cow::Owned(Noise::of(data, data.repeats(), residuals))
    } else {
        Cow::Borrowed(noise)
    }
}
