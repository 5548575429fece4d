//! Look-alikes across the two catalogues: an effect of the measurement in the place of one of the machine, and
//! the reverse. To name one of them alone would be a wrong answer.
//!
//! Both are weighed by −2 ln L, with the prices by which terms and effects are weighed against each other and
//! without: what is no more than the margin of confounded effects behind in either cannot be told apart.

use rayon::prelude::*;

use super::candidate_model::CandidateModel;
use super::change;
use super::confounding::EQUAL_FIT;
use super::instrument::{self, Proposal, criterion, minus_two_log};
use super::lead::{fit_with, starts, without};
use super::moves::SEARCHING;
use super::residual_projection::ProjectedResidual;
use super::search::SearchResult;
use super::sensitivity;
use crate::fit::{StoppingCriterion, minimise, resume};
use crate::measure::Repeats;
use crate::noise::{Acts, FROM, Noise, Shape, Term};
use crate::process::Description;

/// Rise of −2 ln L to first order beyond which an effect is not fitted in the place of a term.
const HOPELESS: f64 = 40.0;
/// Rise of −2 ln L beyond that of an equal fit, at a rough minimum, from which the minimum itself is not sought: a rough
/// one is no more than a ten-thousandth of χ² above it.
const FAR: f64 = 6.0;

/// Something that fits as well in the place of a cause.
pub struct LookAlike<'a> {
    /// The cause: an effect of the machine, or a term by its effect.
    pub cause: Description,
    /// The effect or term that fits as well.
    pub other: Description,
    /// The model with it.
    pub model: CandidateModel<'a>,
}

/// Finds what stands in for each cause of the best model across the catalogues, the nearest first.
pub fn look_alikes<'a>(found: &SearchResult<'a>, best: &CandidateModel<'a>, repeats: &Repeats) -> Vec<LookAlike<'a>> {
    let of_members = best.members.par_iter().flat_map_iter(|member| terms_instead(found, best, *member, repeats));
    let mut all: Vec<LookAlike<'a>> = of_members.collect();
    let data = best.objective.data;
    for (number, term) in best.objective.noise.terms.iter().enumerate() {
        if !term.is_among(&data.terms)
            && matches!(term.effect.acts, Acts::Shared(_))
            && term.effect.shape != Some(Shape::Curve)
        {
            all.extend(effects_instead(found, best, number, repeats));
        }
    }
    all
}

/// −2 ln L of a fitted model, with prices and without.
fn weights(trial: &CandidateModel) -> [f64; 2] {
    [criterion(trial), minus_two_log(trial)]
}

/// How far a model is behind the best, by the kinder of the two.
fn behind(trial: &CandidateModel, best: &CandidateModel) -> f64 {
    let (trial, best) = (weights(trial), weights(best));
    (trial[0] - best[0]).min(trial[1] - best[1])
}

/// Terms in the place of a member of the best model.
fn terms_instead<'a>(
    found: &SearchResult<'a>,
    best: &CandidateModel<'a>,
    member: usize,
    repeats: &Repeats,
) -> Vec<LookAlike<'a>> {
    let Some(rest) = without(&found.base, &found.candidates, best, member) else { return Vec::new() };
    let cause = &found.candidates[member].effect;
    // A step of the instrument has a place and a height, as one of the machine has: they fit alike where χ² is alike,
    // whatever the one pays as noise and the other as a cause.
    let is_step = best.objective.noise.source.is_known() && cause.is_step();
    let rise = |trial: &CandidateModel, term: &Term| match is_step && term.effect.has(FROM) {
        true => behind(trial, best).min(trial.solution.chi2 - best.solution.chi2),
        false => behind(trial, best),
    };
    let stand_in = |(proposal, term): (Proposal, Term)| {
        let mut trial = rest.clone();
        trial.objective.noise = proposal.noise;
        trial.solution = minimise(&mut trial.objective, &rest.solution.position, &[], SEARCHING)?;
        if rise(&trial, &term) > EQUAL_FIT + FAR {
            return None;
        }
        trial.solution = resume(&mut trial.objective, trial.solution, &[], StoppingCriterion::FULL);
        let rise = rise(&trial, &term);
        let other = instrument::description(&term, best.objective.data);
        (rise <= EQUAL_FIT).then(|| (rise, LookAlike { cause: cause.clone(), other, model: trial }))
    };
    // Of each effect the most promising term that fits as well; effects do not wait for each other.
    let mut of_effects: Vec<Vec<(Proposal, Term)>> = Vec::new();
    for proposal in instrument::proposals(&rest, repeats) {
        let newest = proposal.noise.terms.last().filter(|term| matches!(term.effect.acts, Acts::Shared(_)));
        let Some(term) = newest.cloned() else { continue };
        match of_effects.iter_mut().find(|own| own[0].1.effect.name == term.effect.name) {
            Some(own) => own.push((proposal, term)),
            None => of_effects.push(vec![(proposal, term)]),
        }
    }
    let first = |own: Vec<(Proposal, Term)>| own.into_iter().find_map(stand_in);
    let mut all: Vec<(f64, LookAlike<'a>)> = of_effects.into_par_iter().filter_map(first).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, own)| own).collect()
}

/// Effects of the machine in the place of a term of the best model's noise.
fn effects_instead<'a>(
    found: &SearchResult<'a>,
    best: &CandidateModel<'a>,
    number: usize,
    repeats: &Repeats,
) -> Vec<LookAlike<'a>> {
    let data = best.objective.data;
    let term = &best.objective.noise.terms[number];
    let Some(rest) = without_term(best, number, repeats) else { return Vec::new() };
    let may_change =
        |i: &usize| change::has_its_effect(&found.candidates[*i].effect, data.model, best.objective.added.iter());
    let is_absent = |i: &usize| !best.members.contains(i) && may_change(i);
    let absent: Vec<Description> =
        (0..found.candidates.len()).filter(is_absent).map(|i| found.candidates[i].effect.clone()).collect();
    let candidates = sensitivity::candidates(&rest.objective, &rest.solution, &absent);
    let Some(projected) = ProjectedResidual::new(&mut rest.objective.clone(), &rest.solution) else {
        return Vec::new();
    };
    let lost = behind(&rest, best);
    let stand_in = |candidate: usize| {
        let starts = starts(&projected, &candidates[candidate]);
        let fall = starts.first().map_or(0.0, |s| s.1.delta_chi2);
        if lost - fall > HOPELESS + 0.25 * lost {
            return None;
        }
        // Its number means nothing to the search that was made under another noise: it is no member.
        let mut trial = fit_with(&rest, candidate, &candidates[candidate], &starts)?;
        trial.members.truncate(best.members.len());
        if !rest.objective.noise.source.is_known() {
            trial = instrument::resized(&trial, repeats).unwrap_or(trial);
        }
        let rise = behind(&trial, best);
        let (cause, other) = (instrument::description(term, data), candidates[candidate].effect.clone());
        (rise <= EQUAL_FIT).then_some((rise, LookAlike { cause, other, model: trial }))
    };
    let mut all: Vec<(f64, LookAlike<'a>)> = (0..candidates.len()).into_par_iter().filter_map(stand_in).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, own)| own).collect()
}

/// The best model under its noise less one term, fitted again.
fn without_term<'a>(best: &CandidateModel<'a>, number: usize, repeats: &Repeats) -> Option<CandidateModel<'a>> {
    let data = best.objective.data;
    let terms = best.objective.noise.terms_but(number);
    let mut rest = best.clone();
    rest.objective.noise = Noise::beside(&terms, data, repeats, &best.residuals()).0.with(terms, data);
    rest.solution = minimise(&mut rest.objective, &best.solution.position, &[], StoppingCriterion::FULL)?;
    Some(rest)
}
