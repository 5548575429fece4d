//! Searches the sets of effects that are worth believing.
//!
//! Forward selection, the best effect and then the next best, picks wrong sets where sensitivities are alike, and the best
//! set alone is no answer where several say as much. So sets compete by their posterior weight: from every set near the
//! best the search goes on to sets with an effect more, less or exchanged, by the linear model about it, and fits those
//! that promise to be near the best; everything visited is kept.

use super::candidate_model::{CandidateModel, Weighed, key};
use super::laplace;
use super::null_distribution::{MaxStatistic, Variance};
use super::pool::{NoiseChange, Pool};
use super::residual_projection::ProjectedResidual;
use super::screening::Screening;
use super::sensitivity::CandidateEffect;
use crate::progress::Progress;

/// Significance level: an effect is told when chance alone gives as much in a smaller part of searches.
pub const SIGNIFICANCE: f64 = 0.01;

/// Rise of the criterion up to which a set of fewer effects is told in the place of the most probable one: what nine times
/// of ten is there is told by its probability.
pub const PLAINER: f64 = 4.6;
/// Probability of all sets that are told together, and how many are told at most.
pub const TOLD: f64 = 0.95;
pub const MOST_TOLD: usize = 20;

/// How far a search goes, and what it knows beforehand.
#[derive(Clone, Copy)]
pub struct Extent<'e, 'a> {
    /// Most effects that are sought together.
    pub most: usize,
    /// Whether the best set, where it leaves structure, is brought to the deepest minimum that the profiles of
    /// its parameters come upon: as dear as the search itself.
    pub deepens: bool,
    /// Sets that an earlier search has fitted, under another noise.
    pub known: &'e [Weighed<'a>],
    /// How its noise differs from that one.
    pub noise: NoiseChange,
    /// Where progress is told.
    pub progress: &'e Progress,
}

/// Stretch of the null distributions.
const CHANCE: &str = "what chance gives";

/// Result of a search.
#[derive(Clone)]
pub struct SearchResult<'a> {
    /// Model without any candidate effect.
    pub base: CandidateModel<'a>,
    /// Candidate effects that were sought.
    pub candidates: Vec<CandidateEffect>,
    /// Most effects that were sought together.
    pub most: usize,
    /// Best set of each size, up to that of the set that is told.
    pub steps: Vec<CandidateModel<'a>>,
    /// Model with each candidate effect alone, where it can be computed.
    pub singles: Vec<Option<CandidateModel<'a>>>,
    /// All sets that were fitted, the most probable first.
    pub tried: Vec<Weighed<'a>>,
    /// Null distribution of the gain of the first effect.
    pub first_null_distribution: MaxStatistic,
    /// Null distribution of the gain of one effect more, on the last set.
    pub null_distribution: MaxStatistic,
}

impl<'a> SearchResult<'a> {
    /// Set that is told: the plainest of the most probable; the model itself where nothing was found.
    pub fn best(&self) -> &CandidateModel<'a> {
        self.steps.last().unwrap_or(&self.base)
    }

    /// Tells this set in the place of the one that is told.
    pub fn tell(&mut self, set: CandidateModel<'a>) {
        self.steps.truncate(set.members.len() - 1);
        self.steps.push(set);
    }

    /// The other sets that may be true, each with its weight beside this one; `None` where this one was not visited, and so has none.
    pub fn beside(&self, members: &[usize]) -> Option<impl Iterator<Item = (&CandidateModel<'a>, f64)>> {
        let members = key(members);
        let own = self.tried.iter().find(|set| set.model.key() == members)?.criterion;
        let others = self.credible().iter().filter(move |set| set.model.key() != members);
        Some(others.map(move |set| (&set.model, laplace::weight(set.criterion, own))))
    }

    /// The most probable sets, which together hold nearly all of the probability under this noise.
    pub fn credible(&self) -> &[Weighed<'a>] {
        let least = self.tried.first().map_or(0.0, |best| best.criterion);
        let weight = |set: &Weighed| laplace::weight(set.criterion, least);
        let whole: f64 = self.tried.iter().map(weight).sum();
        let mut told = 0.0;
        let is_credible = |set: &&Weighed| {
            told += weight(set);
            told - weight(set) < TOLD * whole
        };
        let count = self.tried.iter().take(MOST_TOLD).take_while(is_credible).count();
        &self.tried[..count]
    }
}

/// Searches sets of up to `most` effects. `None` where the model cannot be computed beside its own best
/// values.
pub fn search<'a>(
    base: CandidateModel<'a>,
    candidates: Vec<CandidateEffect>,
    variance: Variance,
    extent: Extent<'_, 'a>,
) -> Option<SearchResult<'a>> {
    let Extent { most, known, noise, progress, .. } = extent;
    let null_beside = |set: &CandidateModel| {
        progress.stretch(CHANCE, || {
            let projected = ProjectedResidual::new(&mut set.objective.clone(), &set.solution)?;
            // Changes pay for their borders by odds and place, and have a distribution of their own where one is told.
            let is_other = |i: usize, c: &CandidateEffect| !set.members.contains(&i) && c.effect.changes.is_none();
            let others = candidates.iter().enumerate().filter(|(i, c)| is_other(*i, c)).map(|(_, c)| c);
            let screening = Screening::new(&projected, &others.collect::<Vec<_>>());
            Some(MaxStatistic::simulate(&screening, projected.freedom, variance))
        })
    };
    let first_null_distribution = null_beside(&base)?;
    let mut pool = Pool::new(&base, candidates.clone(), most.max(1), known.is_empty());
    progress.stretch("sets that an earlier search has found", || pool.resume(known, noise));
    if noise != NoiseChange::Little {
        progress.stretch("fits of one effect", || pool.singles());
        progress.stretch("fits of sets", || pool.explore(progress));
    } else {
        // What else would be seen is told beside what has been found.
        pool.look_from_the_best();
    }
    let (mut tried, candidates) = pool.emptied();
    let single = |i: usize| tried.iter().find(|set| set.model.members == [i]).map(|set| set.model.clone());
    let singles = (0..candidates.len()).map(single).collect();
    tried.sort_by(|a, b| a.criterion.total_cmp(&b.criterion));
    let steps = loop {
        let steps = plainest(&tried);
        let Some(last) = steps.last().filter(|last| last.objective.jacobian(&last.solution).is_none()) else {
            break steps;
        };
        // On the edge of where the model can be computed nothing can be said about its values.
        let edge = last.key();
        tried.retain(|set| set.model.key() != edge);
    };
    let null_distribution = match steps.last() {
        Some(best) => null_beside(best).unwrap_or_else(|| first_null_distribution.clone()),
        None => first_null_distribution.clone(),
    };
    Some(SearchResult { base, candidates, most, steps, singles, tried, first_null_distribution, null_distribution })
}

/// Best set of each size, up to the smallest that is told in the place of the most probable one.
fn plainest<'a>(tried: &[Weighed<'a>]) -> Vec<CandidateModel<'a>> {
    let near = tried.first().map_or(0.0, |best| best.criterion) + PLAINER;
    let size = tried.iter().take_while(|set| set.criterion <= near).map(|set| set.model.members.len()).min();
    let of_size = |size: usize| tried.iter().find(|set| set.model.members.len() == size).map(|set| set.model.clone());
    (1..=size.unwrap_or(0)).filter_map(of_size).collect()
}
