//! A hypothesis: a noise with what the search found under it.

use super::candidate_model::CandidateModel;
use super::confounding::EQUAL_FIT;
use super::cross_validation::Folds;
use super::search::SearchResult;
use super::verdict::{is_explained, will_be_adequate};
use super::{bent_law, instrument, lead};
use crate::measure::Repeats;
use crate::noise::{Acts, Shape, Term};
use crate::process::Holds;

/// Ratio of held-out errors from which an effect misleads.
const WORSE: f64 = 1.1;

/// A noise with the result of the search under it.
pub struct Hypothesis<'a> {
    /// Result of the search.
    pub found: SearchResult<'a>,
    /// Repeats within the groups that the noise sets apart.
    pub repeats: Repeats,
    /// −2 ln L with penalties.
    pub criterion: f64,
    /// Whether the noise explains what the best set leaves, here and to `compare`.
    pub explains: bool,
}

impl<'a> Hypothesis<'a> {
    /// Judges the result of a search.
    pub fn new(found: SearchResult<'a>, repeats: Repeats) -> Self {
        let criterion = instrument::criterion(found.best());
        let explains = explains(found.best(), &repeats);
        Self { found, repeats, criterion, explains }
    }

    /// Leaves out effects of the machine that cannot be believed: at a bound of what can be computed, or,
    /// where structure remains or stands as a curve in the noise, larger than is plausible, or such that what is
    /// held out is predicted worse with them.
    pub fn leave_out_the_unbelievable(&mut self) {
        let is_strict = |this: &Self| !this.explains || this.describes();
        while let Some(member) = self.found.best().unbelievable(is_strict(self)).or_else(|| self.misleading()) {
            let (base, candidates) = (&self.found.base, &self.found.candidates);
            let rest = lead::without(base, candidates, self.found.best(), member);
            self.replace(rest.filter(|rest| !rest.members.is_empty()));
        }
    }

    /// Leaves out effects of the machine that explain no more than if the law of another one bends. Noise that could
    /// swallow what a model lacks swallows what a bend leaves too, and tells nothing.
    pub fn leave_out_decoration(&mut self) {
        if self.is_greedy() {
            return;
        }
        if let Some(plainer) = bent_law::plainer(&self.found) {
            self.replace(Some(plainer));
        }
    }

    /// Puts another set in the place of the best one; none leaves the model alone.
    fn replace(&mut self, set: Option<CandidateModel<'a>>) {
        self.found.steps.pop();
        match set {
            Some(set) => self.found.steps.push(set),
            None => self.found.steps.clear(),
        }
        self.explains = explains(self.found.best(), &self.repeats);
        self.criterion = instrument::criterion(self.found.best());
    }

    /// Member with which a part, target, sensor or time that is held out is predicted worse than without it,
    /// where structure remains.
    fn misleading(&self) -> Option<usize> {
        let best = self.found.best();
        if self.explains || best.members.is_empty() {
            return None;
        }
        let foldings = Folds::every(best);
        let misleads = |member: &usize| {
            let Some(rest) = lead::without(&self.found.base, &self.found.candidates, best, *member) else {
                return false;
            };
            let errors = foldings.iter().filter_map(|folds| folds.error(best).zip(folds.error(&rest)));
            errors.into_iter().any(|(with, without)| with > WORSE * without)
        };
        best.members.iter().copied().find(misleads)
    }

    /// Whether a zero that was set anew, or a step of it, explains as much as effects of the machine, and takes no
    /// more causes: then nothing shows that the machine is at fault.
    pub fn is_plainer_than(&self, other: &Self) -> bool {
        let (own, others) = (self.found.best(), other.found.best());
        let coordinates = own.objective.data.model.process.coordinates();
        // What goes with a condition, a force or a place, follows a law rather than a hand that sets a zero.
        let is_label =
            |i: &usize| coordinates.get(*i).is_none_or(|c| matches!(c.holds, Holds::Number(_) | Holds::Word(_)));
        let of_zero = |t: &Term| t.effect.sets_zero && t.by.iter().all(is_label);
        let is_of_zero = own.objective.noise.terms.last().is_some_and(of_zero);
        let causes = |trial: &CandidateModel| trial.members.len() + trial.objective.noise.terms.len();
        let is_less = own.members.len() < others.members.len() && causes(own) <= causes(others);
        // What zeros take up is in the determinant already: none pays for its size once more, as where chance is
        // to be kept from adding one.
        let sizes = |trial: &CandidateModel| {
            let shared = trial.objective.noise.terms.iter().filter(|t| matches!(t.effect.acts, Acts::Shared(_)));
            shared.count() as f64 * (trial.objective.data.len() as f64).ln()
        };
        let rise = (self.criterion - sizes(own)) - (other.criterion - sizes(others));
        is_of_zero && self.explains && is_less && rise <= EQUAL_FIT
    }

    /// Whether a curve that no law has stands in its noise.
    fn describes(&self) -> bool {
        self.found.best().objective.noise.terms.iter().any(|t| t.effect.describes())
    }

    /// Whether its noise could swallow what a model lacks.
    pub fn is_greedy(&self) -> bool {
        is_greedy(&self.found.best().objective.noise.terms)
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
