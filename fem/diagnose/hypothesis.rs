//! A hypothesis: a noise with what the search found under it.

use super::candidate_model::CandidateModel;
use super::instrument;
use super::search::SearchResult;
use super::verdict::{is_explained, will_be_adequate};
use crate::measure::Repeats;
use crate::noise::{Acts, Shape, Term};

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
}

impl<'a> Hypothesis<'a> {
    /// Judges the result of a search.
    pub fn new(found: SearchResult<'a>, repeats: Repeats) -> Self {
        let criterion = instrument::criterion(found.best());
        let explains = explains(found.best(), &repeats);
        let least = found.tried.first().map_or(criterion, |set| set.criterion.min(criterion));
        Self { found, repeats, criterion, least, explains }
    }

    /// Whether its noise is believed only where it explains everything.
    pub fn stands_or_falls(&self) -> bool {
        stands_or_falls(&self.found.best().objective.noise.terms)
    }
}

fn explains(best: &CandidateModel, repeats: &Repeats) -> bool {
    let judged = || is_explained(best, repeats) && will_be_adequate(best);
    best.objective.data.progress.stretch("judging hypotheses", judged)
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
