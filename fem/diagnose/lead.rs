//! Sets that are worth fitting: where a fit with one effect more, or one less, begins.

use std::collections::BTreeMap;

use nalgebra::DVector;

use super::candidate_model::{self, CandidateModel};
use super::gain::Gain;
use super::pairs::Pair;
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
/// Stopping criterion that is enough to rank sets; the last set is fitted to full convergence.
pub const SEARCHING: StoppingCriterion = StoppingCriterion::rough(40, 1e-4);

/// Set that is worth fitting.
pub struct Lead<'t, 'a> {
    /// Set from which it grows.
    pub parent: &'t CandidateModel<'a>,
    /// Effect that is added.
    pub added: usize,
    /// Variants of the added effect, each with its gain to first order.
    starts: Vec<(usize, Gain)>,
    /// Start in the variants of a pair with the largest joint gain.
    together: Option<Start>,
    /// Smallest χ² among these starts, to first order.
    pub promised: f64,
}

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

impl<'a> Lead<'_, 'a> {
    /// Members of the set, in rising order.
    pub fn key(&self) -> Vec<usize> {
        candidate_model::key(&self.members())
    }

    /// Members of the set, the added effect last.
    fn members(&self) -> Vec<usize> {
        [&self.parent.members[..], &[self.added]].concat()
    }

    /// Smallest χ² that is believed of a set that has kept this part of an earlier promise.
    pub fn believed(&self, kept: f64) -> f64 {
        let from = self.parent.solution.chi2;
        from - kept * (from - self.promised)
    }

    /// Part of the promised fall that is kept at this χ².
    fn kept(&self, chi2: f64) -> f64 {
        let from = self.parent.solution.chi2;
        if from > self.promised { ((from - chi2) / (from - self.promised)).clamp(0.0, 1.0) } else { 1.0 }
    }

    /// Starts the two effects of a pair together: the first, while alone, may have taken up what belongs to
    /// the second.
    pub fn look_at(
        &mut self,
        pairs: &BTreeMap<(usize, usize), Pair>,
        base: &CandidateModel<'a>,
        left: f64,
        candidates: &[CandidateEffect],
    ) {
        let two = [self.parent.members[0], self.added];
        let Some(pair) = pairs.get(&(two[0].min(two[1]), two[0].max(two[1]))) else { return };
        self.promised = self.promised.min(left - pair.delta_chi2());
        self.together = Some(together(base, pair, two, candidates));
        self.starts.truncate(STARTS - 1);
    }
}

/// Lists every effect that could be added to a set, with its most promising variants.
pub fn leads<'t, 'a>(parent: &'t CandidateModel<'a>, candidates: &[CandidateEffect]) -> Vec<Lead<'t, 'a>> {
    let Some(projected) = ProjectedResidual::new(&mut parent.objective.clone(), &parent.solution) else {
        return Vec::new();
    };
    let lead = |added: usize| {
        let starts = starts(&projected, &candidates[added]);
        let delta_chi2 = starts.first().map_or(0.0, |s| s.1.delta_chi2);
        Lead { parent, added, starts, together: None, promised: parent.solution.chi2 - delta_chi2 }
    };
    (0..candidates.len()).filter(|i| !parent.members.contains(i)).map(lead).filter(|l| !l.starts.is_empty()).collect()
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

/// Fits a set from its starts; from where an earlier search has left it alone, if that is as good as they
/// promise.
pub fn refit<'a>(
    lead: &Lead<'_, 'a>,
    candidates: &[CandidateEffect],
    known: &[CandidateModel<'a>],
) -> Option<CandidateModel<'a>> {
    let candidate = &candidates[lead.added];
    if !lead.parent.objective.data.progress.permits(&format!("fits with `{}`", candidate.effect.name)) {
        return None;
    }
    let mut objective = lead.parent.objective.with(&candidate.effect);
    let (members, key) = (lead.members(), lead.key());
    let mut found = None;
    if let Some(earlier) = known.iter().find(|k| k.key() == key) {
        let mut here = earlier.solution_of(&members, candidates);
        here.chi2 = objective.residuals(&here.position, &here.predicted).norm_squared();
        let kept = earlier.kept;
        if has_the_minimum_of(earlier, &objective) {
            return Some(CandidateModel { members, objective, solution: here, kept });
        }
        let solution = resume(&mut objective, here, SEARCHING);
        // What it did not keep before is not believed again.
        if !is_worth_a_fit(&objective, solution.chi2, lead.believed(kept)) {
            return within_belief(CandidateModel { members, objective, solution, kept });
        }
        found = Some(solution);
    }
    let starts = one_by_one(lead.parent, candidate, &lead.starts, &objective.variables);
    let mut set =
        fit_from(lead.parent, &[lead.added], objective, starts.into_iter().chain(lead.together.clone()), found)?;
    set.kept = lead.kept(set.solution.chi2);
    Some(set)
}

/// Whether a set that stands at `chi2` is worth another fit, of which so small a χ² is believed: the fall must be more
/// than one, where the noise explains what is left, and as much more as what is left is larger.
pub fn is_worth_a_fit(objective: &Objective, chi2: f64, believed: f64) -> bool {
    believed < chi2 - (chi2 / objective.freedom().max(1.0)).max(1.0)
}

/// Whether a set that was fitted under another noise stands at the minimum under this one too: nothing but the level of
/// the noise has changed, and no prior is weighed against it.
fn has_the_minimum_of(known: &CandidateModel, objective: &Objective) -> bool {
    objective.priors() == 0 && known.objective.priors() == 0 && known.objective.noise.is_a_multiple_of(&objective.noise)
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

/// Start of a fit with two effects more, which are added in the order of `two`.
pub fn together(rest: &CandidateModel, pair: &Pair, two: [usize; 2], candidates: &[CandidateEffect]) -> Start {
    let variables = two.iter().fold(rest.objective.clone(), |o, i| o.with(&candidates[*i].effect)).variables;
    let rising = [two[0].min(two[1]), two[0].max(two[1])];
    let mut start = Start::own(&rest.solution.position);
    for number in two {
        let (variant, amplitudes) = pair.of(rising.map(|i| &candidates[i]), usize::from(number == rising[1]));
        start = start.with(&candidates[number].variants[variant], amplitudes, &variables);
    }
    start
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
    within_belief(CandidateModel { members: [&parent.members, added].concat(), objective, solution, kept: 1.0 })
}

fn within_belief(model: CandidateModel) -> Option<CandidateModel> {
    // One effect that takes up all there is stands for all that would; several would be no more than interpolation.
    let is_tested = model.members.len() == 1 || model.objective.is_tested(&model.solution.predicted);
    (is_tested && !model.reads_beyond_belief()).then_some(model)
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
