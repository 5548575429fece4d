//! Searches for the missing effects: sets of effects grow while the gain is more than chance gives (beam
//! search).
//!
//! Forward selection, the best effect and then the next best, picks wrong pairs where sensitivities are
//! alike. So several sets of every size are re-fitted with all parameters free; all pairs are screened, and
//! larger sets grow from the best of the smaller ones.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::DVector;
use rayon::prelude::*;

use super::candidate_model::{self, CandidateModel};
use super::gain::Gain;
use super::null_distribution::{MaxStatistic, Variance};
use super::pairs::{self, Pair};
use super::residual_projection::ProjectedResidual;
use super::sensitivity::{CandidateEffect, Variant};
use crate::fit::{Objective, SearchVariable, Solution, StoppingCriterion, minimise};
use crate::progress::Progress;

/// Significance level: a set grows when chance alone gives as much in a smaller part of searches.
pub const SIGNIFICANCE: f64 = 0.01;
/// Breadth of the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Breadth {
    /// Number of sets from which larger ones grow (beam width).
    beam: usize,
    /// Number of sets that are re-fitted.
    refitted: usize,
}

impl Breadth {
    /// Breadth that is enough as a rule.
    pub const USUAL: Self = Self { beam: 6, refitted: 12 };
    /// Breadth where the usual one left structure: strong effects that are far from linear hide behind
    /// others.
    pub const WIDE: Self = Self { beam: 20, refitted: 60 };
}

/// Starts of a re-fit: the best variants of an effect, each of another neighbourhood.
const STARTS: usize = 2;
/// Most rounds in which an effect of a set is exchanged.
const EXCHANGES: usize = 4;
/// Most halvings of a start at which the model cannot be computed.
const HALVINGS: usize = 5;
/// χ² of the priors above which a re-fit also starts from the prior values.
const BENT: f64 = 9.0;
/// Stopping criterion that is enough to rank sets; the last set is fitted to full convergence.
const SEARCHING: StoppingCriterion = StoppingCriterion { steps: 25, tolerance: 1e-5 };

/// Result of a search.
pub struct SearchResult<'a> {
    /// Model without any candidate effect.
    pub base: CandidateModel<'a>,
    /// Candidate effects that were sought.
    pub candidates: Vec<CandidateEffect>,
    /// Most effects that were sought together.
    pub most: usize,
    /// Best set of each size, as long as the gain was significant.
    pub steps: Vec<CandidateModel<'a>>,
    /// Model with each candidate effect alone, where it can be computed.
    pub singles: Vec<Option<CandidateModel<'a>>>,
    /// All candidate models that were fitted.
    pub tried: Vec<CandidateModel<'a>>,
    /// Null distribution of the gain of the first effect.
    pub first_null_distribution: MaxStatistic,
    /// Null distribution of the gain of one effect more, on the last set.
    pub null_distribution: MaxStatistic,
}

impl<'a> SearchResult<'a> {
    /// Best set; the model itself where nothing was found.
    pub fn best(&self) -> &CandidateModel<'a> {
        self.steps.last().unwrap_or(&self.base)
    }
}

/// Set that is worth fitting.
struct Lead<'t, 'a> {
    parent: &'t CandidateModel<'a>,
    added: usize,
    /// Variants of the added effect, each with its gain to first order.
    starts: Vec<(usize, Gain)>,
    /// Start in the variants of a pair with the largest joint gain.
    together: Option<Start>,
    /// Smallest χ² among these starts, to first order.
    promised: f64,
}

/// Start of a re-fit.
#[derive(Clone)]
struct Start {
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

/// Searches sets of up to `most` effects. `None` where the model cannot be computed beside its own best
/// values.
pub fn search<'a>(
    base: CandidateModel<'a>,
    candidates: Vec<CandidateEffect>,
    variance: Variance,
    (most, breadth): (usize, Breadth),
    progress: &Progress,
) -> Option<SearchResult<'a>> {
    let everyone: Vec<&CandidateEffect> = candidates.iter().collect();
    let projected = ProjectedResidual::new(&mut base.objective.clone(), &base.solution)?;
    let first_null_distribution = MaxStatistic::simulate(&projected, &everyone, variance);
    let mut null_distribution = first_null_distribution.clone();
    // The map keeps an order, so that the same data always give the same answer.
    let mut tried: BTreeMap<Vec<usize>, CandidateModel<'a>> = BTreeMap::new();
    let mut beam = vec![base.clone()];
    let mut steps: Vec<CandidateModel<'a>> = Vec::new();
    let mut singles = Vec::new();
    progress.expect(most as u64);
    for size in 1..=most.max(1) {
        let mut leads: Vec<Lead> = beam.par_iter().flat_map_iter(|parent| leads(parent, &candidates)).collect();
        if size == 2 {
            let pairs = pairs::pairs(&projected, &everyone);
            for lead in &mut leads {
                lead.look_at(&pairs, &base, projected.residual.norm_squared(), &candidates);
            }
        }
        leads.sort_by(|a, b| a.promised.total_cmp(&b.promised));
        let mut seen = BTreeSet::new();
        leads.retain(|lead| {
            let mut members = lead.parent.members.clone();
            members.push(lead.added);
            seen.insert(candidate_model::key(&members))
        });
        leads.truncate(if size == 1 { usize::MAX } else { breadth.refitted });
        let fitted: Vec<CandidateModel<'a>> = leads.par_iter().filter_map(|lead| refit(lead, &candidates)).collect();
        drop(leads);
        if size == 1 {
            let of = |i: usize| fitted.iter().find(|t| t.members == [i]).cloned();
            singles = (0..candidates.len()).map(of).collect();
        }
        beam = fitted.clone();
        beam.sort_by(|a, b| a.penalised_bic().total_cmp(&b.penalised_bic()));
        tried.extend(beam.iter().map(|t| (t.key(), t.clone())));
        let Some(mut best) = beam.first().cloned() else { break };
        if size > 1 {
            beam.truncate(breadth.beam);
            best = exchange(&base, &candidates, best, breadth);
            tried.insert(best.key(), best.clone());
            beam.insert(0, best.clone());
            beam.dedup_by_key(|t| t.key());
        }
        let before = steps.last().unwrap_or(&base);
        if !grows(before, &fitted, &best, &null_distribution, variance, candidates.len()) {
            break;
        }
        steps.push(best.clone());
        progress.advance(1);
        let Some(projected) = ProjectedResidual::new(&mut best.objective.clone(), &best.solution) else { break };
        let others = candidates.iter().enumerate().filter(|(i, _)| !best.members.contains(i)).map(|(_, c)| c);
        null_distribution = MaxStatistic::simulate(&projected, &others.collect::<Vec<_>>(), variance);
    }
    progress.advance((most.max(1) - steps.len()) as u64);
    prune(&base, &candidates, &mut steps, &null_distribution, variance);
    Some(SearchResult {
        base,
        candidates,
        most,
        steps,
        singles,
        tried: tried.into_values().collect(),
        first_null_distribution,
        null_distribution,
    })
}

/// Leaves out effects that the best set does not need, found before others took their place (backward
/// elimination).
fn prune<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    steps: &mut [CandidateModel<'a>],
    null_distribution: &MaxStatistic,
    variance: Variance,
) {
    let Some(best) = steps.last_mut() else { return };
    while best.members.len() > 1 {
        let smaller = best.members.iter().filter_map(|m| without(base, candidates, best, *m));
        let Some(least) = smaller.min_by(|a, b| a.solution.chi2.total_cmp(&b.solution.chi2)) else { return };
        let gained = least.solution.chi2 - best.solution.chi2;
        let p_value =
            null_distribution.p_value(variance.statistic(gained, best.solution.chi2, best.objective.freedom()));
        if p_value < SIGNIFICANCE && best.penalised_bic() < least.penalised_bic() {
            return;
        }
        *best = least;
    }
}

/// Whether a larger set is needed: one effect more gains more than chance gives to a search as wide, or
/// another set gains so much that chance would not give it to any of as many; and the penalised BIC falls.
fn grows(
    before: &CandidateModel,
    fitted: &[CandidateModel],
    best: &CandidateModel,
    null_distribution: &MaxStatistic,
    variance: Variance,
    candidates: usize,
) -> bool {
    let p_value = |larger: &CandidateModel| {
        let gained = before.solution.chi2 - larger.solution.chi2;
        null_distribution.p_value(variance.statistic(gained, larger.solution.chi2, larger.objective.freedom()))
    };
    let nested = fitted.iter().filter(|t| before.members.iter().all(|m| t.members.contains(m)));
    let p_nested = nested.map(p_value).fold(1.0, f64::min);
    let sets = (0..best.members.len()).map(|i| (candidates - i) as f64 / (i + 1) as f64).product::<f64>();
    let p_other = p_value(best) * sets / (candidates - before.members.len()).max(1) as f64;
    p_nested.min(p_other) < SIGNIFICANCE && best.penalised_bic() < before.penalised_bic()
}

/// Lists every effect that could be added to a set, with its most promising variants.
fn leads<'t, 'a>(parent: &'t CandidateModel<'a>, candidates: &[CandidateEffect]) -> Vec<Lead<'t, 'a>> {
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
    trial.solution = Solution { position, predicted, chi2 };
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

/// Exchanges one effect of a set for another, or for itself in another variant, or two for themselves in
/// other variants, as long as the set becomes better by it.
fn exchange<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    mut best: CandidateModel<'a>,
    breadth: Breadth,
) -> CandidateModel<'a> {
    for _ in 0..EXCHANGES {
        let smaller: Vec<CandidateModel> =
            best.members.iter().filter_map(|m| without(base, candidates, &best, *m)).collect();
        let mut leads: Vec<Lead> = smaller.par_iter().flat_map_iter(|parent| leads(parent, candidates)).collect();
        leads.sort_by(|a, b| a.promised.total_cmp(&b.promised));
        leads.truncate(breadth.refitted);
        let mut fitted: Vec<CandidateModel> = leads.par_iter().filter_map(|lead| refit(lead, candidates)).collect();
        if best.members.len() > 2 {
            fitted.extend(reseated(base, candidates, &best));
        }
        let Some(better) = fitted.into_iter().min_by(|a, b| a.penalised_bic().total_cmp(&b.penalised_bic())) else {
            break;
        };
        if better.penalised_bic() >= best.penalised_bic() {
            break;
        }
        best = better;
    }
    best
}

/// Re-fits a set with every two of its effects started in the variants with the largest joint gain beside
/// the rest.
fn reseated<'a>(
    base: &CandidateModel<'a>,
    candidates: &[CandidateEffect],
    set: &CandidateModel<'a>,
) -> Vec<CandidateModel<'a>> {
    let members = set.key();
    let twos: Vec<[usize; 2]> =
        (0..members.len()).flat_map(|j| (0..j).map(move |i| [i, j])).map(|two| two.map(|i| members[i])).collect();
    let reseat = |two: &[usize; 2]| {
        let rest = without(base, candidates, &without(base, candidates, set, two[0])?, two[1])?;
        let projected = ProjectedResidual::new(&mut rest.objective.clone(), &rest.solution)?;
        let pairs = pairs::pairs(&projected, &two.map(|i| &candidates[i]));
        let start = together(&rest, pairs.get(&(0, 1))?, *two, candidates);
        let objective = rest.objective.with(&candidates[two[0]].effect).with(&candidates[two[1]].effect);
        fit_from(&rest, two, objective, [start])
    };
    twos.par_iter().filter_map(reseat).collect()
}

/// Halves the amplitudes of a start until the model can be computed there.
fn nearer(objective: &mut Objective, mut start: Start) -> Option<DVector<f64>> {
    for _ in 0..HALVINGS {
        if objective.predict(&start.position).is_some() {
            return Some(start.position);
        }
        for (variable, neutral) in &start.linear {
            let place = &mut start.position[*variable];
            *place = neutral + 0.5 * (*place - neutral);
        }
    }
    None
}

impl<'a> Lead<'_, 'a> {
    /// Starts the two effects of a pair together: the first, while alone, may have taken up what belongs to
    /// the second.
    fn look_at(
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

/// Start of a fit with two effects more, which are added in the order of `two`.
fn together(rest: &CandidateModel, pair: &Pair, two: [usize; 2], candidates: &[CandidateEffect]) -> Start {
    let variables = two.iter().fold(rest.objective.clone(), |o, i| o.with(&candidates[*i].effect)).variables;
    let rising = [two[0].min(two[1]), two[0].max(two[1])];
    let mut start = Start::own(&rest.solution.position);
    for number in two {
        let (variant, amplitudes) = pair.of(rising.map(|i| &candidates[i]), usize::from(number == rising[1]));
        start = start.with(&candidates[number].variants[variant], amplitudes, &variables);
    }
    start
}

/// Fits a set from its starts.
fn refit<'a>(lead: &Lead<'_, 'a>, candidates: &[CandidateEffect]) -> Option<CandidateModel<'a>> {
    let candidate = &candidates[lead.added];
    let objective = lead.parent.objective.with(&candidate.effect);
    let starts = one_by_one(lead.parent, candidate, &lead.starts, &objective.variables);
    fit_from(lead.parent, &[lead.added], objective, starts.into_iter().chain(lead.together.clone()))
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
    fit_from(parent, &[added], objective, starts)
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

fn fit_from<'a>(
    parent: &CandidateModel<'a>,
    added: &[usize],
    mut objective: Objective<'a>,
    starts: impl IntoIterator<Item = Start>,
) -> Option<CandidateModel<'a>> {
    if objective.freedom() < 1.0 {
        // A model with as many parameters as rows fits anything.
        return None;
    }
    let mut best: Option<Solution> = None;
    for start in starts {
        // A model that lacks an effect is biased away from its priors; from there the way back may be
        // barred.
        let bent = objective.prior_chi2(&start.position) > BENT;
        let written = bent.then(|| Start { position: objective.as_written(&start.position), ..start.clone() });
        for start in std::iter::once(start).chain(written) {
            let found =
                nearer(&mut objective, start).and_then(|start| minimise(&mut objective, &start, &[], SEARCHING));
            best = best.into_iter().chain(found).min_by(|a, b| a.chi2.total_cmp(&b.chi2));
        }
    }
    let solution = best?;
    Some(CandidateModel { members: [&parent.members, added].concat(), objective, solution })
}
