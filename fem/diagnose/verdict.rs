//! How well a model fits, and the verdict that this makes.

use super::candidate_model::CandidateModel;
use super::cross_validation::Folds;
use crate::compare::{self, Comparison, Feature, SIGNIFICANCE, features as find_features};
use crate::fit::{reduced_chi2, told_noise};
use crate::measure::Repeats;
use crate::noise::NoiseLevel;

/// Goodness of fit of a fitted model. SI units.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct GoodnessOfFit {
    /// Root mean square of its residuals, SI; in standard uncertainties where there are several observables.
    pub rms: f64,
    /// Root mean square of the residuals of each of the file's observables, SI.
    #[doc(hidden)]
    pub rms_of: Vec<f64>,
    /// Reduced χ², or lack of fit over pure error (F) with repeats.
    pub reduced_chi2: f64,
    /// Probability that chance alone gives a larger χ² (p-value); `None` where the noise is only estimated.
    pub p_value: Option<f64>,
    /// Root mean square of the cross-validated residuals, of rows that were held out of the fit, in standard
    /// uncertainties.
    pub cross_validation: Option<f64>,
    /// Noise that rms and χ² are told by: where it is only estimated, what neighbouring rows of its own residuals tell.
    #[doc(hidden)]
    pub noise: NoiseLevel,
    /// Prediction of every row.
    pub predicted: Vec<f64>,
}

/// Verdict on a model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Verdict {
    /// Nothing is missing at this noise.
    Adequate,
    /// The named effects bring the model down to the noise.
    MissingEffect,
    /// The named effects help, and structure remains.
    PartlyExplained,
    /// Structure remains that no effect of the catalogue explains.
    Unexplained,
    /// The rows are too few, or too much alike, to tell.
    NotJudged,
}

impl Verdict {
    /// The word in JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::Adequate => "adequate",
            Self::MissingEffect => "missing-effect",
            Self::PartlyExplained => "partly-explained",
            Self::Unexplained => "unexplained",
            Self::NotJudged => "not-judged",
        }
    }

    /// Whether it is one of something that explains the rows.
    pub(super) fn explains(self) -> bool {
        !matches!(self, Self::Unexplained | Self::NotJudged)
    }
}

impl GoodnessOfFit {
    /// Goodness of fit of a candidate model.
    #[doc(hidden)]
    pub fn of(trial: &CandidateModel, repeats: &Repeats, folds: Option<&Folds>) -> Self {
        let (reduced_chi2, p_value) = reduced_chi2(&trial.objective, &trial.solution, repeats);
        let noise = told_noise(&trial.objective, &trial.residuals());
        Self {
            rms: rms(trial),
            noise: noise.level(trial.objective.data),
            rms_of: rms_of(trial),
            reduced_chi2,
            p_value,
            cross_validation: folds.and_then(|f| f.error(trial)),
            predicted: trial.solution.predicted.clone(),
        }
    }
}

impl GoodnessOfFit {
    /// Tells what was held out by a smaller or larger noise than the one by which it was found.
    pub(super) fn tell_held_out_by(&mut self, ratio: f64) {
        self.cross_validation = self.cross_validation.map(|held_out| held_out * ratio);
    }

    /// Whether the noise is as large as what is left, if it is known; what is left may still have structure.
    pub fn is_as_noise(&self) -> bool {
        self.p_value.is_none_or(|p| p >= SIGNIFICANCE)
    }
}

/// Root mean square residual of the rows, SI; in standard uncertainties where there are several observables.
pub fn rms(trial: &CandidateModel) -> f64 {
    let objective = &trial.objective;
    let residuals = trial.residuals();
    let left = objective.noise.unshared(&residuals);
    let left = objective.data.together(&left, &told_noise(objective, &residuals).sigma);
    let counted = left.iter().enumerate().filter(|(row, _)| !objective.noise.is_weighed_down(*row));
    compare::rms(&counted.map(|(_, error)| *error).collect::<Vec<_>>())
}

/// Root mean square residual of the rows of each observable, SI.
fn rms_of(trial: &CandidateModel) -> Vec<f64> {
    let CandidateModel { objective, .. } = trial;
    let residuals = trial.residuals();
    let left = objective.noise.unshared(&residuals);
    let counted = |row: &&usize| !objective.noise.is_weighed_down(**row);
    let of = |rows: Vec<usize>| compare::rms(&rows.iter().filter(counted).map(|row| left[*row]).collect::<Vec<_>>());
    objective.data.rows_by_observable().into_iter().map(of).collect()
}

/// Structure of the residuals of a fitted model.
pub fn features(trial: &CandidateModel) -> Vec<Feature> {
    let objective = &trial.objective;
    find_features(&*objective.data.model.process, objective.data, &trial.residuals(), &objective.noise)
}

/// Whether the noise explains the residuals: every feature that was found is significant.
pub fn is_noise(goodness: &GoodnessOfFit, features: &[Feature]) -> bool {
    goodness.is_as_noise() && features.is_empty()
}

/// Whether the noise explains what a candidate model leaves.
pub fn is_explained(trial: &CandidateModel, repeats: &Repeats) -> bool {
    is_noise(&GoodnessOfFit::of(trial, repeats, None), &features(trial))
}

/// Whether `compare` will call the model adequate that is written with what the candidate model has found.
pub fn will_be_adequate(trial: &CandidateModel) -> bool {
    as_written(trial).adequacy() != Some(false)
}

/// The comparison of the model that is written with what a candidate model has found.
pub fn as_written(trial: &CandidateModel) -> Comparison {
    let objective = &trial.objective;
    compare::judged(objective.data, &objective.noise.terms, trial.solution.predicted.clone())
}
