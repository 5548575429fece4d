//! A hypothesis: a noise with what the search found under it.

use std::cmp::Ordering::Equal;

use super::bent_law;
use super::candidate_model::CandidateModel;
use super::instrument;
use super::search::{PLAINER, SearchResult};
use super::verdict::{is_explained, will_be_adequate};
use crate::measure::Repeats;
use crate::noise::{Acts, Shape, Term, recurs};

/// A noise with the result of the search under it.
pub struct Hypothesis<'a> {
    /// Result of the search.
    pub found: SearchResult<'a>,
    /// Repeats within the groups that the noise sets apart.
    pub repeats: Repeats,
    /// −2 ln of the weight of the set that is told.
    pub criterion: f64,
    /// That of the most probable set.
    pub least: f64,
    /// Whether the noise explains what the best set leaves, here and to `compare`.
    pub explains: bool,
    /// Sets that are likelier where one of their laws bends, by their numbers among those tried, with their criteria then.
    pub bent: Vec<(usize, f64)>,
}

impl<'a> Hypothesis<'a> {
    /// Judges the result of a search. A plainer set of which one law bends takes the place of a larger one.
    pub fn new(mut found: SearchResult<'a>, repeats: Repeats) -> Self {
        let progress = &found.base.objective.data.progress;
        let bent = progress.stretch("laws that bend", || bent_law::bent_sets(&found));
        let mut criterion = instrument::criterion(found.best());
        let mut least = found.tried.first().map_or(criterion, |set| set.criterion.min(criterion));
        least = bent.iter().map(|(_, bent)| *bent).fold(least, f64::min);
        let size = |number: usize| found.tried[number].model.members.len();
        let is_told = |(number, bent): &&(usize, f64)| {
            let is_plainer = size(*number) < found.best().members.len() || criterion > least + PLAINER;
            is_plainer && *bent <= least + PLAINER
        };
        let told =
            bent.iter().filter(is_told).min_by(|a, b| (size(a.0), a.1).partial_cmp(&(size(b.0), b.1)).unwrap_or(Equal));
        if let Some((number, bent)) = told {
            found.tell(found.tried[*number].model.clone());
            criterion = *bent;
        }
        let explains = explains(found.best(), &repeats);
        Self { found, repeats, criterion, least, explains, bent }
    }

    /// Whether its noise is believed only where it explains everything.
    pub fn stands_or_falls(&self) -> bool {
        stands_or_falls(&self.found.best().objective.noise.terms)
    }
}

fn explains(best: &CandidateModel, repeats: &Repeats) -> bool {
    let judged = || is_explained(best, repeats) && will_be_adequate(best) && !is_recurring(best, repeats);
    best.objective.data.progress.stretch("judging hypotheses", judged)
}

/// Whether what a noise that was found swallows comes again in other branches, runs or parts.
fn is_recurring(best: &CandidateModel, repeats: &Repeats) -> bool {
    let Some(mean) = best.objective.mean(&best.solution) else { return false };
    let (data, noise, residuals) = (best.objective.data, &best.objective.noise, best.residuals());
    recurs(&data.evidence(noise, repeats, &residuals, &mean), &data.terms)
}

/// Whether one of these terms could swallow what a model lacks.
pub fn is_greedy(terms: &[Term]) -> bool {
    terms.iter().any(|t| matches!(t.effect.acts, Acts::Neighbours | Acts::Scales))
}

/// Whether one of these terms is believed only where nothing is left beside it: what could swallow what a model lacks,
/// and a wave, of which several make any curve.
pub fn stands_or_falls(terms: &[Term]) -> bool {
    is_greedy(terms) || terms.iter().any(|t| t.effect.shape == Some(Shape::Wave))
}
