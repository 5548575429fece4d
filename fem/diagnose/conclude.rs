//! Makes the diagnosis of the result of a search.

use std::cell::LazyCell;

use super::alternatives::alternatives;
use super::bent_law;
use super::candidate_model::CandidateModel;
use super::change;
use super::confounding::{self, Confounding};
use super::cross_validation::Folds;
use super::diagnosis::{Diagnosis, Missing};
use super::failure::unsolvable;
use super::few_places::few_places;
use super::hypothesis::Hypothesis;
use super::largest_change::{LargestChange, Tangent};
use super::lead;
use super::model_average::Others;
use super::null_distribution::{MaxStatistic, Variance, variance};
use super::outlook::outlooks;
use super::posterior::{CERTAIN, Posterior, may_be_true};
use super::prior_conflict::PriorConflict;
use super::residual_projection::ProjectedResidual;
use super::screening::Screening;
use super::search::SearchResult;
use super::sensitivity::CandidateEffect;
use super::strain::Strain;
use super::verdict::{self, GoodnessOfFit, Verdict};
use super::{doubtful, findings, laplace, look_alike, next};
use crate::compare::Judges;
use crate::fit::{self, Estimate, Fit, StoppingCriterion, minimise};
use crate::input::ParameterId;
use crate::measure::Repeats;
use crate::model::OwnOdds;
use crate::noise::is_round_off;
use crate::process::{Description, Failure};

/// Makes the diagnosis of the result of a search; `None` where its criterion is beyond `limit`.
///
/// # Errors
/// The model cannot be computed beside its best values.
pub fn conclude(
    mut hypotheses: Vec<Hypothesis>,
    conflicts: &[PriorConflict],
    mut posterior: Posterior,
    limit: f64,
) -> Result<Option<Diagnosis>, Failure> {
    let is_imitation = hypotheses.last().is_some_and(imitates);
    if is_imitation {
        hypotheses.truncate(1);
    }
    let Some(Hypothesis { mut found, repeats, bent, .. }) = hypotheses.pop() else { return Err(unsolvable()) };
    posterior.tell_what_is_certain(&mut found);
    let repeats = &repeats;
    let plain = hypotheses.first();
    let variance = variance(&found.base.objective.noise, repeats);
    let folds = Folds::of(&found.base);
    let mut best = found.best().clone();
    let is_certain = |member: &usize| posterior.of(&found.candidates[*member].effect.name) >= CERTAIN;
    let is_plain = best.objective.noise.terms.len() == best.objective.data.terms.len();
    let is_enough = || !best.members.iter().any(is_certain) && verdict::is_explained(&found.base, repeats);
    if is_plain && (is_round_off(&found.base.residuals(), &found.base.objective.data.observed) || is_enough()) {
        // What the noise explains needs no cause where none is certain, and round-off never does.
        best = found.base.clone();
    }
    best.solution =
        minimise(&mut best.objective, &best.solution.position, &[], StoppingCriterion::FULL).ok_or_else(unsolvable)?;
    let goodness = |trial: &CandidateModel| GoodnessOfFit::of(trial, repeats, folds.as_ref());
    let (before, features) = (goodness(&found.base), verdict::features(&found.base));
    let base = &found.base.objective;
    let judges = match base.data.len() < FEWEST_ROWS {
        true => Judges::Nothing,
        false => Judges::of(base.data, &found.base.residuals(), &base.noise, repeats),
    };
    let judged = |best: &CandidateModel| {
        let after = goodness(best);
        let remaining = if best.members.is_empty() { features.clone() } else { verdict::features(best) };
        let own = verdict::verdict(&found.base, best, (&before, &features), (&after, &remaining), judges);
        let is_none = is_imitation && !matches!(own, Verdict::Adequate | Verdict::NotJudged);
        (after, remaining, if is_none { Verdict::Unexplained } else { own })
    };
    let bent = bent_law::criterion_of_values(&found, &bent);
    let (mut after, mut remaining, mut verdict) = judged(&best);
    let told = if explains(verdict) { &best } else { &found.base };
    if laplace::criterion_of_values(told).min(bent) > limit {
        return Ok(None);
    }
    let mut settled = None;
    if explains(verdict) {
        let own = fit::profile_intervals(&mut best.objective, best.solution)?;
        best.solution = own.solution.clone();
        (after, remaining, verdict) = judged(&best);
        settled = Some(own);
    }
    let settled = match settled.filter(|_| explains(verdict)) {
        Some(own) => own,
        None => {
            best = found.base.clone();
            (after, remaining) = (before.clone(), features.clone());
            fit::profile_intervals(&mut best.objective, best.solution.clone())?
        }
    };
    let mut fit = fit::report(&best.objective, settled, repeats);
    if explains(verdict) {
        fit.known.instead = alternatives(&found, &best);
    }
    let strain = Strain::of(&best, doubtful::doubt(&best, folds.as_ref(), &before, &after));
    strain.weaken(&mut posterior);
    let progress = &found.base.objective.data.progress;
    let mut confoundings = match !best.members.is_empty() && progress.permits("effects that look like those found") {
        true => progress.stretch("effects that look alike", || confounding::confoundings(&found)),
        false => Vec::new(),
    };
    confoundings.iter_mut().for_each(|own| own.leave_out_what_is_ruled_out(&found, &posterior));
    let mut missing = missing(&found, &best, &fit, variance, &confoundings, (&goodness, &posterior));
    missing.iter_mut().for_each(|own| own.doubt = strain.doubt(&own.effect));
    let of_measurement = match judges {
        Judges::Nothing => Vec::new(),
        _ => findings::missing_effects(&found.base, &best, plain.map(|h| &h.found.base), repeats, &posterior),
    };
    let outliers = findings::outliers(&best);
    let (before, features) = match plain {
        None => (before, features),
        Some(plain) => {
            let base = &plain.found.base;
            let mut goodness = GoodnessOfFit::of(base, &plain.repeats, folds.as_ref());
            // All of the table is told by one noise, that of the last hypothesis.
            let level = |trial: &CandidateModel| trial.objective.noise.level(trial.objective.data).together();
            goodness.cross_validation = goodness.cross_validation.map(|cv| cv * level(base) / level(&found.base));
            (goodness, verdict::features(base))
        }
    };
    let has_terms = !of_measurement.is_empty();
    missing.splice(0..0, of_measurement);
    if missing.iter().any(Missing::describes) {
        verdict = Verdict::beside_what_describes(&missing);
    } else if has_terms {
        verdict = match verdict {
            Verdict::Adequate => Verdict::MissingEffect,
            Verdict::Unexplained => Verdict::PartlyExplained,
            other => other,
        };
    }
    // What is said here must hold for the model that is written with it.
    let mut suspects = Vec::new();
    if matches!(verdict, Verdict::Adequate | Verdict::MissingEffect) {
        let written = verdict::as_written(&best);
        match written.adequacy() {
            Some(true) => {}
            Some(false) => {
                verdict = if missing.is_empty() { Verdict::Unexplained } else { Verdict::PartlyExplained };
                (remaining, suspects) = (written.features, written.suspects);
            }
            None if missing.is_empty() => verdict = Verdict::NotJudged,
            None => {}
        }
    }
    if verdict == Verdict::MissingEffect && strain.is_of_the_set() {
        verdict = Verdict::PartlyExplained;
    }
    let is_explained = matches!(verdict, Verdict::MissingEffect | Verdict::PartlyExplained);
    let mut look_alikes = match is_explained && progress.permits("effects of the measurement that look alike") {
        true => progress
            .stretch("terms that look alike", || look_alike::look_alikes(&found, &best, best.objective.data.repeats())),
        false => Vec::new(),
    };
    // What the sets rule out in the place of something certain is none; what is not certain has its group; a step of the
    // machine is always held against one of the instrument.
    look_alikes.retain(|own| match posterior.of(&own.cause.name) >= CERTAIN {
        _ if own.cause.is_step() => true,
        true => may_be_true(&found, &own.model),
        false => posterior.are_grouped(&own.cause.name, &own.other.name),
    });
    for own in &look_alikes {
        let named = missing.iter_mut().find(|m| m.effect.name == own.cause.name);
        if let Some(named) = named.filter(|m| m.indistinguishable_from.iter().all(|o| o.name != own.other.name)) {
            named.indistinguishable_from.push(own.other.clone());
        }
    }
    if verdict == Verdict::PartlyExplained
        && let Some(bend) = bent_law::bend(&found, &best)
        && let Some(named) = missing.iter_mut().find(|m| m.effect.name == bend.effect)
    {
        named.bend = Some(bend);
    }
    // Of sets none of which explains the data nothing is believed, and nothing is asked.
    let is_silent = !explains(verdict);
    let posterior = if is_silent { Posterior::default() } else { posterior };
    let next = match !is_silent && progress.permits("what to measure next") {
        true => {
            progress.stretch("what to measure next", || next::next(&found, &confoundings, &look_alikes, &posterior))
        }
        false => None,
    };
    let own = laplace::criterion_of_values(&best);
    let criterion = if is_silent { own } else { bent.min(own) };
    let trials = (best.objective.trials.failures(), best.objective.trials.evaluations());
    let candidates = outlooks(&found, &best, variance, &posterior);
    let verdict_after = match verdict {
        Verdict::MissingEffect => Verdict::Adequate,
        other => other,
    };
    Ok(Some(Diagnosis {
        rows: found.base.objective.data.len(),
        cautions: cautions(&found, (repeats, &fit), verdict, conflicts).into_iter().chain(strain.cautions).collect(),
        noise: found.base.objective.noise.level(found.base.objective.data),
        before,
        features,
        verdict,
        missing,
        outliers,
        verdict_after,
        after,
        fit,
        remaining,
        suspects,
        candidates,
        posterior,
        next,
        criterion,
        cross_validation_by: folds.map(|f| f.coordinate),
        trials,
    }))
}

/// Fewest rows that tell one cause from another, however well each is known: any effect explains what a row or two are off by.
const FEWEST_ROWS: usize = 3;

/// Whether what was found explains anything.
fn explains(verdict: Verdict) -> bool {
    !matches!(verdict, Verdict::Unexplained | Verdict::NotJudged)
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

/// Cautions about the limits of these data.
fn cautions(
    found: &SearchResult,
    (repeats, fit): (&Repeats, &Fit),
    verdict: Verdict,
    conflicts: &[PriorConflict],
) -> Vec<String> {
    let base = &found.base;
    let measurements = base.objective.data;
    let coordinates = base.objective.data.model.process.coordinates();
    let varies = |i: &usize| {
        let column = &measurements.rows.columns[*i];
        !coordinates[*i].repeats && column.iter().any(|v| *v != column[0])
    };
    let mut cautions: Vec<String> = conflicts.iter().map(PriorConflict::text).collect();
    cautions.extend(own_odds(&measurements.model.odds));
    if measurements.progress.is_over() {
        cautions.push("the time was over before the search was: the verdict is about what was tried by then".into());
    }
    cautions.extend(measurements.cautions.iter().chain(&fit.doubts).cloned());
    if !measurements.given.iter().any(varies) {
        cautions
            .push("every row stands at the same place under the same conditions: causes cannot be told apart".into());
    }
    if base.objective.freedom() < 3.0 {
        cautions.push("the rows are so few that almost any cause fits them".into());
    }
    if measurements.uncertainty.is_none() && repeats.scatter.iter().any(|s| s.freedom > 0 && s.sum_of_squares == 0.0) {
        cautions
            .push("rows that repeat each other are identical, as if copied: the noise cannot be judged by them".into());
    }
    cautions.extend(few_places(found.best()));
    let left = matches!(verdict, Verdict::PartlyExplained | Verdict::Unexplained);
    if left && found.best().members.len() == found.most && found.most < found.candidates.len() {
        let most = found.most;
        cautions.push(format!("no more than {most} effects were looked for together; --max-effects looks for more"));
    }
    cautions
}

/// What the model says about odds, on which all probabilities depend.
fn own_odds(odds: &OwnOdds) -> Option<String> {
    let told: Vec<String> = odds.iter().map(|(name, odds)| format!("{odds} to one for {name}")).collect();
    (!told.is_empty())
        .then(|| format!("probabilities follow the odds that the model gives itself: {}", told.join(", ")))
}

/// Lists the effects of the best model, the most needed first, each with its alternatives.
fn missing(
    found: &SearchResult,
    best: &CandidateModel,
    fit: &Fit,
    variance: Variance,
    confoundings: &[Confounding],
    (goodness, posterior): (&dyn Fn(&CandidateModel) -> GoodnessOfFit, &Posterior),
) -> Vec<Missing> {
    let mut list = Vec::new();
    // A thousand searches, the same for every change that is told.
    let of_changes = LazyCell::new(|| null_of_changes(found, best, variance));
    let others = Others::beside(found, best);
    let tangent = Tangent::of(best);
    let widened = |mut estimate: Estimate| {
        if let Some(others) = &others {
            others.widen(&mut estimate, best);
        }
        estimate
    };
    let mut rest = best.clone();
    while !rest.members.is_empty() {
        let is_changed = |m: &usize| {
            let name = &found.candidates[*m].effect.name;
            rest.objective.added.iter().any(|other| other.is_change_of(name))
        };
        // What changes comes before its change.
        let smaller = rest
            .members
            .iter()
            .filter(|m| !is_changed(m))
            .filter_map(|m| lead::without(&found.base, &found.candidates, &rest, *m).map(|t| (*m, t)));
        let Some((last, mut next)) = smaller.min_by(|a, b| a.1.solution.chi2.total_cmp(&b.1.solution.chi2)) else {
            break;
        };
        if let Some(full) = minimise(&mut next.objective, &next.solution.position, &[], StoppingCriterion::FULL) {
            next.solution = full;
        }
        let own = confoundings.iter().find(|p| p.candidate == last);
        let gained = own.map_or(0.0, |p| p.chi2_without - best.solution.chi2);
        let measured = variance.statistic(gained, best.solution.chi2, best.objective.freedom());
        let effect = found.candidates[last].effect.clone();
        let of_change = effect.changes.as_ref().and_then(|_| of_changes.as_ref());
        let null = of_change.unwrap_or(&found.null_distribution);
        let own_paths: Vec<ParameterId> = effect.parameters.iter().map(|p| effect.path(p)).collect();
        list.push(Missing {
            cause: findings::cause(&effect),
            before: before(best, &effect),
            probability: posterior.of(&effect.name),
            doubt: None,
            effect,
            goodness: goodness(&rest),
            p_value: null.p_value(measured),
            estimates: {
                let own = fit.estimates.iter().filter(|e| own_paths.contains(&e.parameter.path));
                own.cloned().map(&widened).collect()
            },
            largest_change: LargestChange::of_member(found, best, last, tangent.as_ref()),
            indistinguishable_from: own.map_or(Vec::new(), |p| {
                p.alternatives.iter().map(|r| found.candidates[r.candidate].effect.clone()).collect()
            }),
            bend: None,
        });
        rest = next;
    }
    list.reverse();
    list
}

/// How often a search finds as much on noise, where changes are sought too: they have many borders.
fn null_of_changes(found: &SearchResult, best: &CandidateModel, variance: Variance) -> Option<MaxStatistic> {
    let projected = ProjectedResidual::new(&mut best.objective.clone(), &best.solution)?;
    let is_sought = |(number, own): &(usize, &CandidateEffect)| match own.effect.changes {
        Some(_) => change::has_its_effect(&own.effect, best.objective.data.model, best.objective.added.iter()),
        None => !best.members.contains(number),
    };
    let sought: Vec<&CandidateEffect> =
        found.candidates.iter().enumerate().filter(is_sought).map(|(_, own)| own).collect();
    Some(MaxStatistic::simulate(&Screening::new(&projected, &sought), projected.freedom, variance))
}

/// The values (SI) that what an effect changes has before, in the order of the effect's parameters; none where it is no
/// change.
fn before(best: &CandidateModel, effect: &Description) -> Vec<f64> {
    let number = |path: ParameterId| best.objective.parameters.iter().position(|p| p.path == path);
    let numbers = effect.parameters.iter().filter(|p| !p.is_step).filter_map(|p| number(effect.path(p)));
    numbers.filter_map(|i| best.objective.unchanged(i, best.solution.position.as_slice())).collect()
}
