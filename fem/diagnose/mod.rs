//! Diagnoses which effect is missing: a search over all effects that the process knows and the model does
//! not have.
//!
//! The model's own free parameters are re-fitted together with every candidate effect; sets of effects grow
//! while Δχ² is more than chance gives to a search as wide (look-elsewhere effect); and confounded effects
//! are named beside those that are found. Structure that no effect explains is described, not explained.

mod candidate_model;
mod conclude;
mod confounding;
mod cross_validation;
mod detection_limit;
mod diagnosis;
mod failure;
mod gain;
mod instrument;
mod lead;
mod next;
mod null_distribution;
mod pairs;
mod plan;
mod prior_conflict;
mod residual_projection;
mod search;
mod sensitivity;
mod verdict;

pub use detection_limit::DetectionLimit;
pub use diagnosis::{Cause, Diagnosis, Missing, Outlier, Outlook};
pub use next::Next;
pub use plan::{Alike, Plan, plan};
pub use search::SIGNIFICANCE;
pub use verdict::{GoodnessOfFit, Verdict};

use crate::fit::{self, Objective, Solution, StoppingCriterion, minimise};
use crate::measure::{Repeats, repeats};
use crate::model::{Data, Model};
use crate::noise::{Acts, MeasurementEffect, Noise, NoiseSource, Term};
use crate::process::{Description, Failure};
use crate::progress::Progress;
use candidate_model::CandidateModel;
use failure::unsolvable;
use instrument::Proposal;
use null_distribution::variance;
use search::{Breadth, SearchResult};

/// Most effects that are sought together, unless told otherwise.
pub const MOST_EFFECTS: usize = 3;
/// Ratio between estimates of the noise up to which it counts as settled.
const SETTLED: f64 = 1.1;

/// Number of rows beyond which they are thinned, whole groups of repeats together: more rows tell causes
/// apart no better than needed, and the time of the search grows with them.
const MOST_ROWS: usize = 2000;

/// Most effects that are sought together, how widely, and where progress is told.
type Extent<'p> = (usize, Breadth, &'p Progress);

/// Most effects of the measurement that are sought.
const MOST_TERMS: usize = 3;
/// Fall of −2 ln L, beyond its price, from which a term is worth a search and is kept.
const PROMISING: f64 = 6.0;
/// Rise of −2 ln L up to which a term is tried in the place of all effects of the machine.
const INSTEAD: f64 = 15.0;
/// Terms of which each is tried in a search of its own.
const TOGETHER: usize = 3;
/// Searches in which the sizes of terms settle.
const ROUNDS: usize = 2;

/// Searches for up to `most` effects that the model lacks.
///
/// # Errors
/// The data are too few, or the model cannot be computed.
pub fn diagnose(data: &Data, most: usize, progress: &Progress) -> Result<Diagnosis, Failure> {
    let coordinates = data.model.process.coordinates();
    let all = repeats(data, coordinates);
    let every = data.len().div_ceil(MOST_ROWS);
    if every > 1 {
        let some = data.some(|row| all.group[row].is_multiple_of(every));
        return diagnose_all(&some, &repeats(&some, coordinates), most, progress);
    }
    diagnose_all(data, &all, most, progress)
}

fn diagnose_all(data: &Data, repeats: &Repeats, most: usize, progress: &Progress) -> Result<Diagnosis, Failure> {
    progress.expect(1);
    let breadth = Breadth::USUAL;
    let absent = absent(data.model);
    let mut objective = Objective::new(data)?;
    let mut solution = fit::best(&mut objective)?;
    let residuals: Vec<f64> = data.observed.iter().zip(&solution.predicted).map(|(y, p)| y - p).collect();
    let mean = objective.mean(&solution).ok_or_else(unsolvable)?;
    let (noise, within) = Noise::stated(&data.terms, data, repeats, &residuals, &mean);
    objective.noise = noise;
    let mut found = look_until_settled(&mut objective, &mut solution, &absent, &within, (most, breadth, progress))?;
    let mut conflicts = Vec::new();
    while let Some((parameter, conflict)) = prior_conflict::conflicting_prior(&found, &within) {
        objective.variables[parameter].prior = None;
        conflicts.push(conflict);
        found = look_until_settled(&mut objective, &mut solution, &absent, &within, (most, breadth, progress))?;
    }
    let first = Hypothesis::new(found, within);
    let mut hypotheses = explore(first, &solution, &absent, repeats, (most, breadth, progress))?;
    let Some(last) = hypotheses.pop() else { return Err(unsolvable()) };
    let mut last = widened(last, &solution, &absent, (most, Breadth::WIDE, progress))?;
    if !last.explains {
        // The last resort: a curve over places that no law here has, beside which causes are judged.
        let curves = instrument::curves(last.found.best(), repeats);
        let bare = instrument::curves(&last.found.base, repeats);
        let curves = curves.into_iter().chain(bare).filter(|p| p.criterion < last.criterion + INSTEAD).collect();
        if let Some(beside) = further(&last, curves, &solution, &absent, repeats, (most, breadth, progress))? {
            hypotheses.push(std::mem::replace(&mut last, beside));
        }
    }
    last.leave_out_the_unbelievable();
    hypotheses.push(last);
    let diagnosis = conclude::conclude(hypotheses, &conflicts);
    progress.advance(1);
    diagnosis
}

/// A noise with the result of the search under it.
pub struct Hypothesis<'a> {
    found: SearchResult<'a>,
    /// Repeats within the groups that the noise sets apart.
    repeats: Repeats,
    /// −2 ln L with penalties.
    criterion: f64,
    /// Whether the noise explains what the best set leaves.
    explains: bool,
}

impl<'a> Hypothesis<'a> {
    fn new(found: SearchResult<'a>, repeats: Repeats) -> Self {
        let criterion = instrument::criterion(found.best());
        let goodness = GoodnessOfFit::of(found.best(), &repeats, None);
        let explains = verdict::is_noise(&goodness, &verdict::features(found.best()));
        Self { found, repeats, criterion, explains }
    }

    fn terms(&self) -> &[Term] {
        &self.found.best().objective.noise.terms
    }

    /// Leaves out effects of the machine that cannot be believed: at a bound of what can be computed, or,
    /// where structure remains, larger than is plausible.
    fn leave_out_the_unbelievable(&mut self) {
        while let Some(member) = self.found.best().unbelievable(!self.explains) {
            let (base, candidates) = (&self.found.base, &self.found.candidates);
            match lead::without(base, candidates, self.found.best(), member) {
                Some(rest) if !rest.members.is_empty() => {
                    self.found.steps.pop();
                    self.found.steps.push(rest);
                }
                _ => self.found.steps.clear(),
            }
            let goodness = GoodnessOfFit::of(self.found.best(), &self.repeats, None);
            self.explains = verdict::is_noise(&goodness, &verdict::features(self.found.best()));
        }
    }

    /// Whether its noise could swallow what a model lacks: it is believed only where it explains everything.
    fn is_greedy(&self) -> bool {
        self.terms().iter().any(|t| matches!(t.effect.acts, Acts::Neighbours | Acts::Scales))
    }
}

/// Looks for effects of the measurement together with those of the machine: terms are added to the noise one
/// after another, the most promising first, and everything is sought again under each, as long as the
/// likelihood rises by more than its price. The first hypothesis comes first, the best last.
fn explore<'a>(
    first: Hypothesis<'a>,
    start: &Solution,
    absent: &[Description],
    repeats: &Repeats,
    extent: Extent,
) -> Result<Vec<Hypothesis<'a>>, Failure> {
    let mut path = vec![first];
    // Rows that contradict their own repeats are wrong whatever the model says.
    let wrong = path.first().and_then(|first| instrument::contradictions(&first.found.base, repeats));
    if let (Some(wrong), Some(first)) = (wrong, path.first()) {
        let without = under(&first.found.base, wrong, start, absent, repeats, extent)?;
        path.push(without);
    }
    for _ in 0..MOST_TERMS {
        let Some(here) = path.last() else { break };
        let mut proposals = instrument::proposals(here.found.best(), repeats);
        proposals.retain(|p| p.criterion < here.criterion - PROMISING);
        if !here.found.best().members.is_empty() {
            let instead = instrument::proposals(&here.found.base, repeats);
            proposals.extend(instead.into_iter().filter(|p| p.criterion < here.criterion + INSTEAD));
        }
        let Some(better) = further(here, proposals, start, absent, repeats, extent)? else { break };
        path.push(better);
    }
    while path.len() > 1 && path.last().is_some_and(|h| h.is_greedy() && !h.explains) {
        path.pop();
    }
    Ok(path)
}

/// The best hypothesis with one term more, of those that are worth a search; `None` where none is better.
fn further<'a>(
    here: &Hypothesis<'a>,
    mut proposals: Vec<Proposal>,
    start: &Solution,
    absent: &[Description],
    repeats: &Repeats,
    extent: Extent,
) -> Result<Option<Hypothesis<'a>>, Failure> {
    proposals.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    let mut best: Option<Hypothesis> = None;
    let mut looked: Vec<&MeasurementEffect> = Vec::new();
    for proposal in proposals {
        // The best of each effect is looked at: their neighbours would say the same.
        let Some(newest) = proposal.noise.terms.last().map(|t| t.effect) else { continue };
        if looked.len() == TOGETHER || looked.contains(&newest) {
            continue;
        }
        looked.push(newest);
        if best.as_ref().is_some_and(|b| b.explains && proposal.criterion > b.criterion + INSTEAD) {
            // What explains everything is not likely to be beaten from so far behind.
            continue;
        }
        let found = under(&here.found.base, proposal, start, absent, repeats, extent)?;
        if best.as_ref().is_none_or(|b| found.criterion < b.criterion) {
            best = Some(found);
        }
    }
    Ok(best.filter(|b| b.criterion < here.criterion - PROMISING))
}

/// Searches widely where the usual search left structure: strong effects that are far from linear hide behind
/// others.
fn widened<'a>(
    last: Hypothesis<'a>,
    start: &Solution,
    absent: &[Description],
    extent: Extent,
) -> Result<Hypothesis<'a>, Failure> {
    if last.explains || last.found.best().members.is_empty() {
        return Ok(last);
    }
    let mut objective = last.found.base.objective.clone();
    let found = look_until_settled(&mut objective, &mut start.clone(), absent, &last.repeats, extent)?;
    let wide = Hypothesis::new(found, last.repeats.clone());
    Ok(if wide.criterion < last.criterion { wide } else { last })
}

/// Searches under a noise; its sizes are settled with what is found.
fn under<'a>(
    base: &CandidateModel<'a>,
    proposal: Proposal,
    start: &Solution,
    absent: &[Description],
    repeats: &Repeats,
    (most, breadth, progress): Extent,
) -> Result<Hypothesis<'a>, Failure> {
    let mut objective = base.objective.clone();
    let mut solution = start.clone();
    let mut within = proposal.repeats;
    objective.noise = proposal.noise;
    let mut found = look_until_settled(&mut objective, &mut solution, absent, &within, (most, breadth, progress))?;
    for _ in 0..ROUNDS {
        let Some((noise, own)) = instrument::settled(found.best(), repeats) else { break };
        let sizes = noise.terms.iter().zip(&found.best().objective.noise.terms);
        let is_settled = sizes.into_iter().all(|(a, b)| (1.0 / SETTLED..SETTLED).contains(&(a.size / b.size)));
        (objective.noise, within) = (noise, own);
        found = look_until_settled(&mut objective, &mut solution, absent, &within, (most, breadth, progress))?;
        if is_settled {
            break;
        }
    }
    Ok(Hypothesis::new(found, within))
}

/// Repeats the search until the residuals of the best model agree with the noise that it was found with.
fn look_until_settled<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[Description],
    repeats: &Repeats,
    (most, breadth, progress): Extent,
) -> Result<SearchResult<'a>, Failure> {
    /// Most searches after the first.
    const MOST: usize = 4;
    let mut found = look(objective, solution, absent, repeats, (most, breadth, progress))?;
    if objective.noise.source == NoiseSource::Estimated {
        for _ in 0..MOST {
            let left = found.best().objective.residual_noise(&found.best().solution);
            let settled = left.is_about(&objective.noise, SETTLED);
            objective.noise = left;
            found = look(objective, solution, absent, repeats, (most, breadth, progress))?;
            if settled {
                break;
            }
        }
    }
    Ok(found)
}

/// Effects of the process that the model does not have and that could act in it.
fn absent(model: &Model) -> Vec<Description> {
    let is_absent = |d: &Description| model.effects.iter().all(|e| e.description != *d);
    model.process.effects().into_iter().filter(is_absent).filter(|d| model.system.admits(d.name).is_ok()).collect()
}

/// Searches once, with a given noise.
fn look<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[Description],
    repeats: &Repeats,
    (most, breadth, progress): Extent,
) -> Result<SearchResult<'a>, Failure> {
    *solution = minimise(objective, &solution.position, &[], StoppingCriterion::FULL).ok_or_else(unsolvable)?;
    let candidates = sensitivity::candidates(objective, solution, absent);
    let base = CandidateModel { members: Vec::new(), objective: objective.clone(), solution: solution.clone() };
    let variance = variance(&objective.noise, repeats);
    let mut found = search::search(base, candidates, variance, (most, breadth), progress).ok_or_else(unsolvable)?;
    let goodness = GoodnessOfFit::of(found.best(), repeats, None);
    let explains = found.best().members.is_empty() || verdict::is_noise(&goodness, &verdict::features(found.best()));
    if let Some(best) = found.steps.last_mut().filter(|_| !explains) {
        // The best model may stand in a shallow minimum.
        best.solution = fit::profile_intervals(&mut best.objective, best.solution.clone())?.solution;
    }
    Ok(found)
}
