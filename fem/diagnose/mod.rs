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
pub use diagnosis::{Diagnosis, Missing, Outlook};
pub use next::Next;
pub use plan::{Alike, Plan, plan};
pub use search::SIGNIFICANCE;
pub use verdict::{GoodnessOfFit, Verdict};

use crate::compare::{Noise, NoiseSource};
use crate::fit::{self, Objective, Solution, StoppingCriterion, minimise};
use crate::measure::{Repeats, repeats};
use crate::model::{Data, Model};
use crate::process::{Description, Failure};
use crate::progress::Progress;
use candidate_model::CandidateModel;
use failure::unsolvable;
use null_distribution::variance;
use search::{Breadth, SearchResult};

/// Most effects that are sought together, unless told otherwise.
pub const MOST_EFFECTS: usize = 3;
/// Ratio between estimates of the noise up to which it counts as settled.
const SETTLED: f64 = 1.1;

/// Number of rows beyond which they are thinned, whole groups of repeats together: more rows tell causes
/// apart no better than needed, and the time of the search grows with them.
const MOST_ROWS: usize = 2000;

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
    let absent = absent(data.model);
    let mut objective = Objective::new(data)?;
    let mut solution = fit::best(&mut objective)?;
    let residuals: Vec<f64> = data.observed.iter().zip(&solution.predicted).map(|(y, p)| y - p).collect();
    objective.noise = Noise::of(data, repeats, &residuals);
    let mut found = look_until_settled(&mut objective, &mut solution, &absent, repeats, (most, progress))?;
    let mut conflicts = Vec::new();
    while let Some((parameter, conflict)) = prior_conflict::conflicting_prior(&found, repeats) {
        objective.variables[parameter].prior = None;
        conflicts.push(conflict);
        found = look_until_settled(&mut objective, &mut solution, &absent, repeats, (most, progress))?;
    }
    let diagnosis = conclude::conclude(found, repeats, &conflicts);
    progress.advance(1);
    diagnosis
}

/// Repeats the search until the residuals of the best model agree with the noise that it was found with.
fn look_until_settled<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[Description],
    repeats: &Repeats,
    (most, progress): (usize, &Progress),
) -> Result<SearchResult<'a>, Failure> {
    /// Most searches after the first.
    const MOST: usize = 4;
    let mut found = look(objective, solution, absent, repeats, (most, progress))?;
    if objective.noise.source == NoiseSource::Estimated {
        for _ in 0..MOST {
            let left = found.best().objective.residual_noise(&found.best().solution);
            let settled = left.is_about(&objective.noise, SETTLED);
            objective.noise = left;
            found = look(objective, solution, absent, repeats, (most, progress))?;
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
    (most, progress): (usize, &Progress),
) -> Result<SearchResult<'a>, Failure> {
    *solution = minimise(objective, &solution.position, &[], StoppingCriterion::FULL).ok_or_else(unsolvable)?;
    let candidates = sensitivity::candidates(objective, solution, absent);
    let base = CandidateModel { members: Vec::new(), objective: objective.clone(), solution: solution.clone() };
    let variance = variance(&objective.noise, repeats);
    let mut found = search::search(base.clone(), candidates.clone(), variance, (most, Breadth::USUAL), progress)
        .ok_or_else(unsolvable)?;
    let explains = |best: &CandidateModel| {
        let goodness = GoodnessOfFit::of(best, repeats, None);
        best.members.is_empty() || verdict::is_noise(&goodness, &verdict::features(best))
    };
    if explains(found.best()) {
        return Ok(found);
    }
    if let Some(best) = found.steps.last_mut() {
        // The best model may stand in a shallow minimum.
        best.solution = fit::profile_intervals(&mut best.objective, best.solution.clone())?.solution;
        if explains(best) {
            return Ok(found);
        }
    }
    search::search(base, candidates, variance, (most, Breadth::WIDE), progress).ok_or_else(unsolvable)
}
