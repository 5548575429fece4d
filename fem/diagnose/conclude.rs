//! Makes the diagnosis of the result of a search.

use super::alternatives::alternatives;
use super::bent_law;
use super::candidate_model::CandidateModel;
use super::cautions::cautions;
use super::confounding::{self, Confounding};
use super::cross_validation::Folds;
use super::diagnosis::{Diagnosis, Missing};
use super::failure::unsolvable;
use super::hypothesis::Hypothesis;
use super::judge::{Judge, Judgement};
use super::look_alike::{self, LookAlike};
use super::missing::missing;
use super::outlook::outlooks;
use super::posterior::{CERTAIN, Posterior, may_be_true};
use super::prior_conflict::Released;
use super::search::SearchResult;
use super::strain::Strain;
use super::verdict::{self, GoodnessOfFit, Verdict};
use super::{doubtful, findings, laplace, next};
use crate::fit::{self, Fit, StoppingCriterion, minimise};
use crate::measure::Repeats;
use crate::noise::{NoiseSource, is_round_off};
use crate::process::Failure;

/// Makes the diagnosis of the result of a search; `None` where its criterion is beyond `limit`.
///
/// # Errors
/// The model cannot be computed beside its best values.
pub fn conclude(
    mut hypotheses: Vec<Hypothesis>,
    released: &Released,
    mut posterior: Posterior,
    limit: f64,
) -> Result<Option<Diagnosis>, Failure> {
    let is_imitation = hypotheses.last().is_some_and(imitates);
    if is_imitation {
        hypotheses.truncate(1);
    }
    let Some(Hypothesis { mut found, repeats, bent, .. }) = hypotheses.pop() else { return Err(unsolvable()) };
    posterior.tell_what_is_certain(&mut found);
    let judge = Judge::of(&found.base, &repeats, is_imitation);
    let bent = bent_law::criterion_of_values(&found, &bent);
    let is_hopeless = |set: &CandidateModel| laplace::criterion_of_values(set).min(bent) > limit;
    let Some((best, mut judgement, fit)) = settled(&found, &judge, &posterior, is_hopeless)? else { return Ok(None) };
    let foresight = doubtful::doubt(&best, judge.folds.as_ref(), &judge.before, &judgement.goodness);
    let strain = Strain::of(&best, foresight.into_iter().chain(doubtful::too_few(&best, judge.judges)));
    strain.weaken(&mut posterior);
    let confoundings = confoundings(&found, &best, &posterior);
    let mut missing = missing(&found, &best, &fit, &confoundings, (&judge, &posterior));
    missing.iter_mut().for_each(|own| own.doubt = strain.doubt(&own.effect));
    let plain = hypotheses.first();
    let terms = match judge.can_judge() {
        true => findings::missing_effects(&found.base, &best, plain.map(|h| &h.found.base), &repeats, &posterior),
        false => Vec::new(),
    };
    let has_terms = !terms.is_empty();
    missing.splice(0..0, terms);
    judgement.verdict = judgement.verdict.beside(&missing, has_terms);
    judgement.hold_against_what_is_written(&best, missing.is_empty());
    if judgement.verdict == Verdict::MissingEffect && strain.is_of_the_set() {
        judgement.verdict = Verdict::PartlyExplained;
    }
    let verdict = judgement.verdict;
    let look_alikes = match verdict {
        Verdict::MissingEffect | Verdict::PartlyExplained => look_alikes(&found, &best, &posterior),
        _ => Vec::new(),
    };
    stand_beside(&mut missing, &look_alikes);
    if verdict == Verdict::PartlyExplained {
        tell_the_bend(&mut missing, &found, &best);
    }
    // Of sets none of which explains the data nothing is believed, and nothing is asked.
    let is_silent = !verdict.explains();
    let posterior = if is_silent { Posterior::default() } else { posterior };
    let progress = &found.base.objective.data.progress;
    let next = match !is_silent && progress.permits("what to measure next") {
        true => {
            progress.stretch("what to measure next", || next::next(&found, &confoundings, &look_alikes, &posterior))
        }
        false => None,
    };
    let own = laplace::criterion_of_values(&best);
    // Before anything was found or released.
    let first = released.held.as_ref().or(plain.map(|plain| &plain.found.base));
    let within = plain.map_or(&repeats, |plain| &plain.repeats);
    let mut before = before(first.unwrap_or(&found.base), within, (&found.base, judge.folds.as_ref()));
    let features = first.map_or_else(|| judge.features.clone(), verdict::features);
    // What was held out is told by the noise that all of it is told by.
    let noise = judgement.goodness.noise.clone();
    let searched = found.base.objective.noise.level(found.base.objective.data);
    let steps = missing.iter_mut().map(|own| &mut own.goodness).chain([&mut before, &mut judgement.goodness]);
    steps.for_each(|own| own.tell_held_out_by(searched.together() / noise.together()));
    Ok(Some(Diagnosis {
        rows: found.base.objective.data.len(),
        cautions: cautions(&found, (&repeats, &fit), verdict, released).into_iter().chain(strain.cautions).collect(),
        noise,
        before,
        features,
        verdict,
        judges: judge.judges,
        released: released.conflicts.iter().map(|own| own.parameter.path.to_string()).collect(),
        missing,
        outliers: findings::outliers(&best),
        verdict_after: if verdict == Verdict::MissingEffect { Verdict::Adequate } else { verdict },
        after: judgement.goodness,
        fit,
        remaining: judgement.features,
        suspects: judgement.suspects,
        trials: (best.objective.trials.failures(), best.objective.trials.evaluations()),
        candidates: outlooks(&found, &best, judge.variance, &posterior),
        posterior,
        next,
        criterion: if is_silent { own } else { bent.min(own) },
        cross_validation_by: judge.folds.map(|folds| folds.coordinate),
    }))
}

/// Whether the rows are one series, which a few laws imitate whatever made it, and those that were found predict stretches
/// of it that are held out far worse than the noise.
fn imitates(last: &Hypothesis) -> bool {
    /// Root mean square of the errors on what is held out, in standard uncertainties, beyond which a law is no law.
    const FAR: f64 = 2.0;
    let Hypothesis { found, repeats, .. } = last;
    let held_out = || GoodnessOfFit::of(found.best(), repeats, Folds::of(&found.base).as_ref()).cross_validation;
    found.base.objective.only_span().is_some() && held_out().is_some_and(|held| held > FAR)
}

/// The set that is told, with its judgement and the fit of all its values: the best that was found, or none of it where that
/// explains nothing. `None` where the search is hopeless.
fn settled<'a>(
    found: &SearchResult<'a>,
    judge: &Judge,
    posterior: &Posterior,
    is_hopeless: impl Fn(&CandidateModel) -> bool,
) -> Result<Option<(CandidateModel<'a>, Judgement, Fit)>, Failure> {
    let mut best = told(found, judge, posterior);
    best.solution =
        minimise(&mut best.objective, &best.solution.position, &[], StoppingCriterion::FULL).ok_or_else(unsolvable)?;
    let mut judgement = judge.judge(&best);
    if is_hopeless(if judgement.verdict.explains() { &best } else { &found.base }) {
        return Ok(None);
    }
    if judgement.verdict.explains() {
        let profiled = fit::profile_intervals(&mut best.objective, best.solution)?;
        best.solution = profiled.solution.clone();
        judgement = judge.judge(&best);
        if judgement.verdict.explains() {
            let mut fit = fit::report(&best.objective, profiled, judge.repeats);
            fit.known.instead = alternatives(found, &best);
            return Ok(Some((best, judgement, fit)));
        }
    }
    let mut base = found.base.clone();
    let profiled = fit::profile_intervals(&mut base.objective, base.solution.clone())?;
    let fit = fit::report(&base.objective, profiled, judge.repeats);
    Ok(Some((base, judge.of_base(judgement.verdict), fit)))
}

/// The best set, or none where it is not needed: what the noise explains needs no cause where none is certain, and round-off
/// never does.
fn told<'a>(found: &SearchResult<'a>, judge: &Judge, posterior: &Posterior) -> CandidateModel<'a> {
    let best = found.best();
    let is_certain = |member: &usize| posterior.of(&found.candidates[*member].effect.name) >= CERTAIN;
    let is_plain = best.objective.noise.terms.len() == best.objective.data.terms.len();
    let is_enough = || !best.members.iter().any(is_certain) && verdict::is_explained(&found.base, judge.repeats);
    let is_round_off = || is_round_off(&found.base.residuals(), &found.base.objective.data.observed);
    if is_plain && (is_round_off() || is_enough()) { found.base.clone() } else { best.clone() }
}

/// What stands beside each effect of the best set, but for what is ruled out.
fn confoundings<'a>(
    found: &SearchResult<'a>,
    best: &CandidateModel<'a>,
    posterior: &Posterior,
) -> Vec<Confounding<'a>> {
    let progress = &found.base.objective.data.progress;
    if best.members.is_empty() || !progress.permits("effects that look like those found") {
        return Vec::new();
    }
    let mut all = progress.stretch("effects that look alike", || confounding::confoundings(found));
    all.iter_mut().for_each(|own| own.leave_out_what_is_ruled_out(found, posterior));
    all
}

/// Look-alikes across the two catalogues. What the sets rule out in the place of something certain is none; what is not certain
/// has its group; a step of the machine is always held against one of the instrument.
fn look_alikes<'a>(found: &SearchResult<'a>, best: &CandidateModel<'a>, posterior: &Posterior) -> Vec<LookAlike<'a>> {
    let data = best.objective.data;
    if !data.progress.permits("effects of the measurement that look alike") {
        return Vec::new();
    }
    let find = || look_alike::look_alikes(found, best, data.repeats());
    let mut all = data.progress.stretch("terms that look alike", find);
    all.retain(|own| match posterior.of(&own.cause.name) >= CERTAIN {
        _ if own.cause.is_step() => true,
        true => may_be_true(found, &own.model),
        false => posterior.are_grouped(&own.cause.name, &own.other.name),
    });
    all
}

/// Names what looks like each cause beside it.
fn stand_beside(missing: &mut [Missing], look_alikes: &[LookAlike]) {
    for own in look_alikes {
        let named = missing.iter_mut().find(|m| m.effect.name == own.cause.name);
        if let Some(named) = named.filter(|m| m.indistinguishable_from.iter().all(|o| o.name != own.other.name)) {
            named.indistinguishable_from.push(own.other.clone());
        }
    }
}

/// Tells of the cause whose law bends how it does.
fn tell_the_bend(missing: &mut [Missing], found: &SearchResult, best: &CandidateModel) {
    if let Some(bend) = bent_law::bend(found, best)
        && let Some(named) = missing.iter_mut().find(|m| m.effect.name == bend.effect)
    {
        named.bend = Some(bend);
    }
}

/// Goodness of fit of the first model of all, as a fit of it has it: where the noise is only estimated, what is roughly known
/// weighs against all that this model leaves. What is held out is told by one noise in all of the table, that of the last
/// hypothesis, whose model without effects is `last`.
fn before(
    first: &CandidateModel,
    repeats: &Repeats,
    (last, folds): (&CandidateModel, Option<&Folds>),
) -> GoodnessOfFit {
    let level = |trial: &CandidateModel| trial.objective.noise.level(trial.objective.data).together();
    let mut goodness = GoodnessOfFit::of(first, repeats, folds);
    goodness.tell_held_out_by(level(first) / level(last));
    match weighed_alone(first) {
        None => goodness,
        Some(alone) => {
            GoodnessOfFit { cross_validation: goodness.cross_validation, ..GoodnessOfFit::of(&alone, repeats, None) }
        }
    }
}

/// A model under the noise that it leaves itself, where that is only estimated and values are roughly known.
fn weighed_alone<'a>(base: &CandidateModel<'a>) -> Option<CandidateModel<'a>> {
    let is_weighed = base.objective.noise.source == NoiseSource::Estimated && base.objective.priors() > 0;
    let mut alone = is_weighed.then(|| base.clone())?;
    (alone.solution, _) = fit::settled(&mut alone.objective, alone.solution).ok()?;
    Some(alone)
}
