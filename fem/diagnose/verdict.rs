//! The verdict: whether the noise explains what is left, before and after.

use super::held_out::Folds;
use super::trial::Trial;
use crate::compare::{self, Feature, NoiseSource, features as find_features};
use crate::fit::judge;
use crate::measure::Repeats;

/// The noise explains a residual when chance alone gives a larger misfit, or a more striking structure, this often. Half of what the search may
/// spend, for both are looked at.
const UNEXPLAINED: f64 = 0.005;
/// Effects that explain less than this part of what the noise does not are not named as the cause.
const HALF: f64 = 0.5;

/// How well a fitted model agrees with the data. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Root mean square residual.
    pub rms: f64,
    /// χ²/ν, or lack of fit over pure error.
    pub misfit: f64,
    /// How often chance alone gives more; `None` where the noise is only estimated.
    pub p_value: Option<f64>,
    /// Root mean square of the residuals of rows that were held out of the fit, in standard uncertainties.
    pub held_out: Option<f64>,
    /// Prediction of every row.
    pub predicted: Vec<f64>,
}

/// What is to be said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Nothing is missing at this noise.
    Adequate,
    /// The named effects bring the model down to the noise.
    MissingEffect,
    /// They help, and structure remains.
    PartlyExplained,
    /// Structure that nothing in the catalogue explains.
    Unexplained,
}

impl State {
    /// Of a fitted model.
    pub fn of(trial: &Trial, repeats: &Repeats, folds: Option<&Folds>) -> Self {
        let (misfit, p_value) = judge(&trial.objective, &trial.solution, repeats);
        Self {
            rms: rms(trial),
            misfit,
            p_value,
            held_out: folds.and_then(|f| f.error(trial)),
            predicted: trial.solution.predicted.clone(),
        }
    }
}

/// Root mean square residual of the rows, in standard uncertainties where there are several observables.
pub fn rms(trial: &Trial) -> f64 {
    let objective = &trial.objective;
    compare::rms(&objective.measurements.together(&residuals(trial), &objective.noise.sigma))
}

fn residuals(trial: &Trial) -> Vec<f64> {
    trial.objective.measurements.observed.iter().zip(&trial.solution.predicted).map(|(y, p)| y - p).collect()
}

/// Where a fitted model fails.
pub fn features(trial: &Trial) -> Vec<Feature> {
    let objective = &trial.objective;
    find_features(objective.model.process, objective.measurements, &residuals(trial), &objective.noise)
}

/// The verdict on the model before and with the best set.
pub fn verdict(base: &Trial, best: &Trial, before: (&State, &[Feature]), after: (&State, &[Feature])) -> Verdict {
    match (best.members.is_empty(), is_noise(after.0, after.1)) {
        (true, true) => Verdict::Adequate,
        (true, false) => Verdict::Unexplained,
        (false, true) => Verdict::MissingEffect,
        (false, false) => {
            let (was, is) = (excess(base, before.1), excess(best, after.1));
            if 1.0 - is / was < HALF { Verdict::Unexplained } else { Verdict::PartlyExplained }
        }
    }
}

/// Whether the noise explains what is left.
pub fn is_noise(state: &State, features: &[Feature]) -> bool {
    state.p_value.is_none_or(|p| p >= UNEXPLAINED) && features.iter().all(|f| f.p_value >= UNEXPLAINED)
}

/// What of χ² the noise does not explain. Where the noise is only estimated, the share of what has structure.
fn excess(trial: &Trial, features: &[Feature]) -> f64 {
    let chi2 = trial.solution.chi2;
    match trial.objective.noise.source {
        NoiseSource::Column | NoiseSource::Repeats => (chi2 - trial.objective.freedom()).max(0.0),
        NoiseSource::Estimated => chi2 * features.iter().map(|f| f.share).fold(0.0, f64::max),
    }
}
