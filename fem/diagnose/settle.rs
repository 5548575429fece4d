//! A search whose noise is settled with what it finds.

use super::candidate_model::CandidateModel;
use super::failure::unsolvable;
use super::like_a_curve;
use super::null_distribution::variance;
use super::pool::NoiseChange;
use super::search::{self, Extent, SearchResult};
use super::verdict::is_explained;
use crate::fit::{self, Objective, Solution, StoppingCriterion, resume};
use crate::measure::Repeats;
use crate::noise::NoiseSource;
use crate::process::{Description, Failure};
use crate::progress::Progress;

/// Ratio between estimates of the noise up to which it counts as settled.
pub const SETTLED: f64 = 1.1;

/// Fall of χ² from which a minimum was a shallow one.
const SHALLOW: f64 = 1.0;

/// Repeats the search until the residuals of the best model agree with the noise that it was found with.
pub fn look_until_settled<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[Description],
    repeats: &Repeats,
    extent: Extent<'_, 'a>,
) -> Result<SearchResult<'a>, Failure> {
    /// Most searches after the first.
    const MOST: usize = 4;
    let mut found = look(objective, solution, absent, repeats, extent)?;
    for _ in 0..if objective.noise.source == NoiseSource::Estimated { MOST } else { 0 } {
        if !extent.progress.permits("the noise settled with what was found") {
            return Ok(found);
        }
        let before = extent.progress.is_limited().then(|| (found.clone(), objective.noise.clone(), solution.clone()));
        let (next, settled) = look_again(objective, solution, absent, found, repeats, extent)?;
        found = next;
        if let (Some(before), true) = (before, extent.progress.is_over()) {
            // A search that was cut off finds less than the one before it.
            (found, objective.noise, *solution) = before;
            break;
        }
        if settled {
            break;
        }
    }
    let is_time = extent.progress.permits("deeper minima of the best set");
    if extent.deepens
        && is_time
        && deepen(&mut found, repeats, extent.progress)?
        && objective.noise.source == NoiseSource::Estimated
    {
        found = look_again(objective, solution, absent, found, repeats, extent)?.0;
    }
    Ok(found)
}

/// Searches with the noise that a search has left; also whether that is the noise that it was given.
fn look_again<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[Description],
    mut found: SearchResult<'a>,
    repeats: &Repeats,
    extent: Extent<'_, 'a>,
) -> Result<(SearchResult<'a>, bool), Failure> {
    let left = found.best().objective.residual_noise(&found.best().solution);
    let settled = left.is_about(&objective.noise, SETTLED);
    objective.noise = left;
    let known = std::mem::take(&mut found.tried);
    let extent = Extent { known: &known, noise: NoiseChange::of_size(settled), ..extent };
    let next = look(objective, solution, absent, repeats, extent)?;
    Ok((next, settled))
}

/// Brings the best set, where it leaves structure, to the deepest minimum that the profiles of its parameters
/// come upon; also whether it was deeper.
fn deepen(found: &mut SearchResult, repeats: &Repeats, progress: &Progress) -> Result<bool, Failure> {
    let Some(best) = found.steps.last_mut().filter(|best| !is_explained(best, repeats)) else { return Ok(false) };
    let before = best.solution.chi2;
    let deeper = || fit::profile_intervals(&mut best.objective, best.solution.clone());
    best.solution = progress.stretch("deeper minima along profiles", deeper)?.solution;
    Ok(best.solution.chi2 < before - SHALLOW)
}

/// Searches once, with a given noise.
fn look<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[Description],
    repeats: &Repeats,
    extent: Extent<'_, 'a>,
) -> Result<SearchResult<'a>, Failure> {
    // The model is at its minimum already but for the noise, under which its slopes stay what they are.
    solution.chi2 = objective.residuals(&solution.position, &solution.predicted).norm_squared();
    *solution = resume(objective, solution.clone(), &[], StoppingCriterion::FULL);
    let sought = || like_a_curve::candidates(objective, solution, absent);
    let candidates = extent.progress.stretch("what each effect would change", sought);
    let base = CandidateModel { members: Vec::new(), objective: objective.clone(), solution: solution.clone() };
    let variance = variance(&objective.noise, repeats);
    search::search(base, candidates, variance, extent).ok_or_else(unsolvable)
}
