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
    let last = hypotheses.pop().map(|last| widened(last, &solution, &absent, (most, Breadth::WIDE, progress)));
    hypotheses.extend(last.transpose()?);
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
    (most, breadth, progress): Extent,
) -> Result<Vec<Hypothesis<'a>>, Failure> {
    let mut path = vec![first];
    for _ in 0..MOST_TERMS {
        let Some(here) = path.last() else { break };
        let mut proposals = instrument::proposals(here.found.best(), repeats);
        let least = here.criterion - PROMISING;
        proposals.retain(|p| p.criterion < least);
        if !here.found.best().members.is_empty() {
            let instead = instrument::proposals(&here.found.base, repeats);
            proposals.extend(instead.into_iter().filter(|p| p.criterion < here.criterion + INSTEAD));
        }
        proposals.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
        if std::env::var("FEM_DEBUG").is_ok() {
            eprintln!(
                "HERE {} {:?} {:?}",
                here.criterion,
                here.terms().iter().map(|t| (t.effect.name, t.size)).collect::<Vec<_>>(),
                here.found.best().members
            );
            for p in &proposals {
                eprintln!(
                    "  {} {:?}",
                    p.criterion,
                    p.noise
                        .terms
                        .iter()
                        .map(|t| (t.effect.name, t.size, t.by.clone(), t.rows.clone()))
                        .collect::<Vec<_>>()
                );
            }
        }
        let mut best: Option<Hypothesis> = None;
        let mut looked: Vec<&MeasurementEffect> = Vec::new();
        for proposal in proposals {
            // The best of each effect is looked at: their neighbours would say the same.
            let Some(newest) = proposal.noise.terms.last().map(|t| t.effect) else { continue };
            if looked.len() == TOGETHER || looked.contains(&newest) {
                continue;
            }
            looked.push(newest);
            let found = under(&here.found.base, proposal, start, absent, repeats, (most, breadth, progress))?;
            if std::env::var("FEM_DEBUG").is_ok() {
                eprintln!(
                    "  -> {:?} {} {:?} {}",
                    found.terms().iter().map(|t| (t.effect.name, t.size)).collect::<Vec<_>>(),
                    found.criterion,
                    found.found.best().members,
                    found.explains
                );
            }
            if best.as_ref().is_none_or(|b| found.criterion < b.criterion) {
                best = Some(found);
            }
        }
        let Some(best) = best.filter(|b| b.criterion < here.criterion - PROMISING) else { break };
        path.push(best);
    }
    while path.len() > 1 && path.last().is_some_and(|h| h.is_greedy() && !h.explains) {
        path.pop();
    }
    Ok(path)
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
