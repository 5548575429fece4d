//! Sets that are worth fitting: where a fit with one effect more, or one less, begins.

use nalgebra::DVector;

use super::candidate_model::CandidateModel;
use super::gain::Gain;
use super::moves::SEARCHING;
use super::residual_projection::ProjectedResidual;
use super::sensitivity::{CandidateEffect, Variant};
use crate::fit::{Objective, SearchVariable, Solution, StoppingCriterion, minimise, resume};

/// Starts of a re-fit: the best variants of an effect, each of another neighbourhood.
const STARTS: usize = 2;
/// Most halvings of a start at which the model cannot be computed.
const HALVINGS: usize = 5;
/// χ² of the priors above which a re-fit also starts from the prior values.
const BENT: f64 = 9.0;
/// Stopping criterion of a few steps, after which only the best of several starts goes on.
const AHEAD: StoppingCriterion = StoppingCriterion::rough(6, 1e-4);

/// Start of a re-fit.
#[derive(Clone)]
pub struct Start {
    position: DVector<f64>,
    /// Linear parameters of the added effects (number of the search variable), with their neutral values.
    linear: Vec<(usize, f64)>,
}

impl Start {
    /// Starts with the model's own variables at `values`, and no effect yet.
    fn own(values: &DVector<f64>) -> Self {
        Self { position: values.clone(), linear: Vec::new() }
    }

    /// Adds an effect, whose variables come next among `variables`.
    fn with(mut self, variant: &Variant, amplitudes: &[f64], variables: &[SearchVariable]) -> Self {
        let first = self.position.len();
        let own = variant.position(amplitudes, &variables[first..]);
        self.linear.extend(variant.linear.iter().map(|s| (first + s.parameter, variant.position[s.parameter])));
        self.position = DVector::from_iterator(first + own.len(), self.position.iter().copied().chain(own));
        self
    }
}

/// Most promising variants of an effect.
pub fn starts(projected: &ProjectedResidual, candidate: &CandidateEffect) -> Vec<(usize, Gain)> {
    promising(candidate.variants.iter().map(|v| projected.gain(v)).collect())
}

/// Selects the best gains of all variants, each in another neighbourhood: neighbours on the grid run into
/// the same minimum.
pub fn promising(gains: Vec<Gain>) -> Vec<(usize, Gain)> {
    let mut all: Vec<(usize, Gain)> = gains.into_iter().enumerate().collect();
    all.sort_by(|a, b| b.1.delta_chi2.total_cmp(&a.1.delta_chi2));
    let mut chosen: Vec<(usize, Gain)> = Vec::new();
    for (i, gain) in all {
        if chosen.iter().all(|(j, _)| i.abs_diff(*j) > 1) && chosen.len() < STARTS {
            chosen.push((i, gain));
        }
    }
    chosen
}

/// Fits a set with one candidate effect more from the given starts.
pub fn fit_with<'a>(
    parent: &CandidateModel<'a>,
    added: usize,
    candidate: &CandidateEffect,
    starts: &[(usize, Gain)],
) -> Option<CandidateModel<'a>> {
    let objective = parent.objective.with(&candidate.effect);
    let starts = one_by_one(parent, candidate, starts, &objective.variables);
    fit_from(parent, &[added], objective, starts, None)
}

/// Starts where the set stands, with the new effect in each of its variants.
fn one_by_one(
    parent: &CandidateModel,
    candidate: &CandidateEffect,
    starts: &[(usize, Gain)],
    variables: &[SearchVariable],
) -> Vec<Start> {
    let own = Start::own(&parent.solution.position);
    starts.iter().map(|(v, gain)| own.clone().with(&candidate.variants[*v], &gain.amplitudes, variables)).collect()
}

/// Fits a set from its starts, and keeps the deepest minimum, among which may be one that is known.
pub fn fit_from<'a>(
    parent: &CandidateModel<'a>,
    added: &[usize],
    mut objective: Objective<'a>,
    starts: impl IntoIterator<Item = Start>,
    mut best: Option<Solution>,
) -> Option<CandidateModel<'a>> {
    if objective.freedom() < 1.0 {
        // A model with as many parameters as rows fits anything.
        return None;
    }
    for start in starts {
        // A model that lacks an effect is biased away from its priors; from there the way back may be
        // barred.
        let bent = objective.prior_chi2(&start.position) > BENT;
        let written = bent.then(|| Start { position: objective.as_written(&start.position), ..start.clone() });
        for start in std::iter::once(start).chain(written) {
            best = best.into_iter().chain(ahead(&mut objective, start)).min_by(|a, b| a.chi2.total_cmp(&b.chi2));
        }
    }
    let solution = resume(&mut objective, best?, SEARCHING);
    Some(CandidateModel { members: [&parent.members, added].concat(), objective, solution })
}

/// Goes a few steps from a start, whose amplitudes are halved until the model can be computed there.
fn ahead(objective: &mut Objective, mut start: Start) -> Option<Solution> {
    for _ in 0..HALVINGS {
        if let Some(found) = minimise(objective, &start.position, &[], AHEAD) {
            return Some(found);
        }
        for (variable, neutral) in &start.linear {
            let place = &mut start.position[*variable];
            *place = neutral + 0.5 * (*place - neutral);
        }
    }
    None
}

/// Takes an effect out of a set, all other values unchanged.
pub fn bare<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    set: &CandidateModel<'a>,
    member: usize,
) -> Option<CandidateModel<'a>> {
    let mut trial = base.clone();
    let mut position = set.solution.position.iter().copied();
    let mut kept: Vec<f64> = position.by_ref().take(base.objective.variables.len()).collect();
    for &m in &set.members {
        let values: Vec<f64> = position.by_ref().take(candidates[m].parameters).collect();
        if m != member {
            trial.objective = trial.objective.with(&candidates[m].effect);
            trial.members.push(m);
            kept.extend(values);
        }
    }
    let position = DVector::from_vec(kept);
    let predicted = trial.objective.predict(&position)?;
    let chi2 = trial.objective.residuals(&position, &predicted).norm_squared();
    trial.solution = Solution { position, predicted, chi2, slopes: None };
    Some(trial)
}

/// Takes an effect out of a set, and re-fits.
pub fn without<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    set: &CandidateModel<'a>,
    member: usize,
) -> Option<CandidateModel<'a>> {
    let mut trial = bare(base, candidates, set, member)?;
    let start = trial.solution.position.clone();
    trial.solution = minimise(&mut trial.objective, &start, &[], SEARCHING)?;
    Some(trial)
}
