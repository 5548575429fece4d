//! Sets that are worth fitting: where a fit with one effect more, or one less, begins.

use nalgebra::DVector;

use super::candidate_model::CandidateModel;
use super::gain::Gain;
use super::moves::{SEARCHING, apart, best_first};
use super::residual_projection::ProjectedResidual;
use super::sensitivity::{CandidateEffect, Variant};
use crate::fit::{Objective, Solution, StoppingCriterion, minimise, resume};

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
struct Start {
    position: DVector<f64>,
    /// Linear parameters of the added effect (number of the search variable), with their neutral values.
    linear: Vec<(usize, f64)>,
}

impl Start {
    /// Starts where a set stands, with an effect more, whose variables come last in the objective.
    fn new(parent: &CandidateModel, variant: &Variant, amplitudes: &[f64], objective: &Objective) -> Self {
        let mut position: Vec<f64> = parent.solution.position.iter().copied().collect();
        let first = position.len();
        position.extend(variant.position(amplitudes, &objective.variables[first..]));
        let from = variant.moved(&mut position, first, objective);
        let linear = variant.linear.iter().zip(from).map(|(s, from)| (first + s.parameter, from)).collect();
        Self { position: DVector::from_vec(position), linear }
    }
}

/// Most promising variants of an effect.
pub fn starts(projected: &ProjectedResidual, candidate: &CandidateEffect) -> Vec<(usize, Gain)> {
    promising(candidate.variants.iter().map(|v| projected.gain(v)).collect())
}

/// Selects the best gains of all variants, each in another neighbourhood: neighbours on the grid run into
/// the same minimum.
pub fn promising(gains: Vec<Gain>) -> Vec<(usize, Gain)> {
    apart(&best_first(gains), STARTS)
}

/// Fits a set with one candidate effect more from the given starts, and keeps the deepest minimum.
pub fn fit_with<'a>(
    parent: &CandidateModel<'a>,
    added: usize,
    candidate: &CandidateEffect,
    starts: &[(usize, Gain)],
) -> Option<CandidateModel<'a>> {
    let mut objective = parent.objective.with(&candidate.effect);
    if objective.freedom() < 1.0 {
        // A model with as many parameters as rows fits anything.
        return None;
    }
    let mut best: Option<Solution> = None;
    for (variant, gain) in starts {
        let start = Start::new(parent, &candidate.variants[*variant], &gain.amplitudes, &objective);
        // A model that lacks an effect is biased away from its priors; from there the way back may be
        // barred.
        let bent = objective.prior_chi2(&start.position) > BENT;
        let written = bent.then(|| Start { position: objective.as_written(&start.position), ..start.clone() });
        for start in std::iter::once(start).chain(written) {
            best = best.into_iter().chain(ahead(&mut objective, start)).min_by(|a, b| a.chi2.total_cmp(&b.chi2));
        }
    }
    let solution = resume(&mut objective, best?, &[], SEARCHING);
    Some(CandidateModel { members: [&parent.members[..], &[added]].concat(), objective, solution })
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
    trial.solution = trial.objective.evaluate(position)?;
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
