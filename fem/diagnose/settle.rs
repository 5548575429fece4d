//! A search whose noise is settled with what it finds.

use super::candidate_model::CandidateModel;
use super::failure::unsolvable;
use super::null_distribution::variance;
use super::search::{self, Breadth, SearchResult};
use super::sensitivity;
use super::verdict::is_explained;
use crate::fit::{self, Objective, Solution, StoppingCriterion, minimise};
use crate::measure::Repeats;
use crate::noise::NoiseSource;
use crate::process::{Description, Failure};
use crate::progress::Progress;

/// Ratio between estimates of the noise up to which it counts as settled.
pub const SETTLED: f64 = 1.1;

/// Most effects that are sought together, how widely, and where progress is told.
pub type Extent<'p> = (usize, Breadth, &'p Progress);

/// Repeats the search until the residuals of the best model agree with the noise that it was found with.
pub fn look_until_settled<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[Description],
    repeats: &Repeats,
    extent: Extent,
) -> Result<SearchResult<'a>, Failure> {
    /// Most searches after the first.
    const MOST: usize = 4;
    let mut found = look(objective, solution, absent, repeats, extent)?;
    if objective.noise.source == NoiseSource::Estimated {
        for _ in 0..MOST {
            let left = found.best().objective.residual_noise(&found.best().solution);
            let settled = left.is_about(&objective.noise, SETTLED);
            objective.noise = left;
            found = look(objective, solution, absent, repeats, extent)?;
            if settled {
                break;
            }
        }
    }
    Ok(found)
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
    let explains = found.best().members.is_empty() || is_explained(found.best(), repeats);
    if let Some(best) = found.steps.last_mut().filter(|_| !explains) {
        // The best model may stand in a shallow minimum.
        best.solution = fit::profile_intervals(&mut best.objective, best.solution.clone())?.solution;
    }
    Ok(found)
}
