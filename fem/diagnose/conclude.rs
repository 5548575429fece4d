//! Makes the diagnosis of the result of a search.

use super::bent_law;
use super::candidate_model::CandidateModel;
use super::confounding::{self, Confounding};
use super::cross_validation::Folds;
use super::detection_limit::detection_limit;
use super::diagnosis::{Diagnosis, Missing, Outlook};
use super::failure::unsolvable;
use super::hypothesis::Hypothesis;
use super::lead;
use super::null_distribution::{Variance, variance};
use super::prior_conflict::PriorConflict;
use super::residual_projection::ProjectedResidual;
use super::search::{SIGNIFICANCE, SearchResult};
use super::verdict::{self, GoodnessOfFit, Verdict};
use super::{findings, look_alike, next, sensitivity};
use crate::fit::{self, Fit, StoppingCriterion, minimise};
use crate::input::ParameterId;
use crate::measure::Repeats;
use crate::process::Failure;

/// Makes the diagnosis of the result of a search.
///
/// # Errors
/// The model cannot be computed beside its best values.
pub fn conclude(mut hypotheses: Vec<Hypothesis>, conflicts: &[PriorConflict]) -> Result<Diagnosis, Failure> {
    let Some(Hypothesis { found, repeats, .. }) = hypotheses.pop() else { return Err(unsolvable()) };
    let repeats = &repeats;
    let plain = hypotheses.first();
    let variance = variance(&found.base.objective.noise, repeats);
    let folds = Folds::of(&found.base);
    let mut best = found.best().clone();
    best.solution =
        minimise(&mut best.objective, &best.solution.position, &[], StoppingCriterion::FULL).ok_or_else(unsolvable)?;
    let mut settled = fit::profile_intervals(&mut best.objective, best.solution)?;
    best.solution = settled.solution.clone();
    let goodness = |trial: &CandidateModel| GoodnessOfFit::of(trial, repeats, folds.as_ref());
    let (before, mut after) = (goodness(&found.base), goodness(&best));
    let features = verdict::features(&found.base);
    let mut remaining = if best.members.is_empty() { features.clone() } else { verdict::features(&best) };
    let mut verdict = verdict::verdict(&found.base, &best, (&before, &features), (&after, &remaining));
    if verdict == Verdict::Unexplained {
        best = found.base.clone();
        settled = fit::profile_intervals(&mut best.objective, best.solution.clone())?;
        after = before.clone();
        remaining = features.clone();
    }
    let fit = fit::report(&best.objective, settled, repeats);
    let progress = &found.base.objective.data.progress;
    let confoundings = match !best.members.is_empty() && progress.permits("effects that look like those found") {
        true => progress.stretch("effects that look alike", || confounding::confoundings(&found)),
        false => Vec::new(),
    };
    let mut missing = missing(&found, &best, &fit, variance, &confoundings, &goodness);
    let of_measurement = findings::missing_effects(&found.base, &best, plain.map(|h| &h.found.base), repeats);
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
    let stated = &found.base.objective.data.terms;
    if best.objective.noise.terms.iter().any(|t| t.effect.describes() && !t.is_among(stated)) {
        // A curve or a wave that no law has describes; it explains nothing.
        let alone = best.members.is_empty() && of_measurement.iter().all(Missing::describes);
        verdict = if alone { Verdict::Unexplained } else { Verdict::PartlyExplained };
        missing.splice(0..0, of_measurement);
    } else if !of_measurement.is_empty() {
        verdict = match verdict {
            Verdict::Adequate => Verdict::MissingEffect,
            Verdict::Unexplained => Verdict::PartlyExplained,
            other => other,
        };
        missing.splice(0..0, of_measurement);
    }
    // What is said here must hold for the model that is written with it.
    let mut suspects = Vec::new();
    if matches!(verdict, Verdict::Adequate | Verdict::MissingEffect) {
        let written = verdict::as_written(&best);
        if written.adequacy() == Some(false) {
            verdict = if missing.is_empty() { Verdict::Unexplained } else { Verdict::PartlyExplained };
            (remaining, suspects) = (written.features, written.suspects);
        }
    }
    let is_explained = matches!(verdict, Verdict::MissingEffect | Verdict::PartlyExplained);
    let look_alikes = match is_explained && progress.permits("effects of the measurement that look alike") {
        true => progress
            .stretch("terms that look alike", || look_alike::look_alikes(&found, &best, best.objective.data.repeats())),
        false => Vec::new(),
    };
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
    let next = match progress.permits("what to measure next") {
        true => progress.stretch("what to measure next", || next::next(&found, &best, &confoundings, &look_alikes)),
        false => None,
    };
    let trials = (best.objective.trials.failures(), best.objective.trials.evaluations());
    let candidates = outlooks(&found, &best, variance);
    let verdict_after = match verdict {
        Verdict::MissingEffect => Verdict::Adequate,
        other => other,
    };
    Ok(Diagnosis {
        rows: found.base.objective.data.len(),
        cautions: cautions(&found, (repeats, &fit), verdict, conflicts),
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
        next,
        cross_validation_by: folds.map(|f| f.coordinate),
        trials,
    })
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
    if left && found.steps.len() == found.most && found.most < found.candidates.len() {
        let most = found.most;
        cautions.push(format!("no more than {most} effects were looked for together; --max-effects looks for more"));
    }
    cautions
}

/// Says that causes stand on few places of a coordinate along which a curve could be anything: with hardly
/// more places than parameters a few laws imitate any curve.
fn few_places(best: &CandidateModel) -> Option<String> {
    /// Places beyond the parameters from which a curve contradicts wrong laws.
    const MORE: usize = 3;
    let data = best.objective.data;
    let coordinates = data.model.process.coordinates();
    let (at, (name, _)) = data.given.iter().find_map(|i| Some((*i, coordinates[*i].curve?)))?;
    let places = data.levels(&[at]).into_iter().max().map_or(0, |most| most + 1);
    let free = best.objective.variables.len() - best.objective.priors();
    (!best.members.is_empty() && places < free + MORE).then(|| {
        let along = &coordinates[at].name;
        format!("{places} values of `{along}` hardly tell these causes from a {name}: measure at further ones between")
    })
}

/// Lists the effects of the best model, the most needed first, each with its alternatives.
fn missing(
    found: &SearchResult,
    best: &CandidateModel,
    fit: &Fit,
    variance: Variance,
    confoundings: &[Confounding],
    goodness: &dyn Fn(&CandidateModel) -> GoodnessOfFit,
) -> Vec<Missing> {
    let mut list = Vec::new();
    let mut rest = best.clone();
    while !rest.members.is_empty() {
        let smaller = rest
            .members
            .iter()
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
        let own_paths: Vec<ParameterId> = effect.parameters.iter().map(|p| effect.path(p)).collect();
        list.push(Missing {
            cause: findings::cause(&effect),
            effect,
            goodness: goodness(&rest),
            p_value: found.null_distribution.p_value(measured),
            estimates: fit.estimates.iter().filter(|e| own_paths.contains(&e.parameter.path)).cloned().collect(),
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

/// Evaluates every candidate effect.
fn outlooks(found: &SearchResult, best: &CandidateModel, variance: Variance) -> Vec<Outlook> {
    let projected = ProjectedResidual::new(&mut best.objective.clone(), &best.solution);
    let threshold = found.null_distribution.quantile(SIGNIFICANCE);
    let outlook = |(candidate, single): (&sensitivity::CandidateEffect, &Option<CandidateModel>)| {
        // What was not tried for want of time would not have been found.
        let is_tried = single.is_some() || !best.objective.data.progress.is_over();
        let detection_limit =
            projected.as_ref().filter(|_| is_tried).and_then(|g| detection_limit(g, candidate, threshold));
        let gained = single.as_ref().map_or(0.0, |t| found.base.solution.chi2 - t.solution.chi2);
        let measured =
            single.as_ref().map_or(0.0, |t| variance.statistic(gained, t.solution.chi2, t.objective.freedom()));
        Outlook {
            effect: candidate.effect.clone(),
            rms: single.as_ref().map(verdict::rms),
            delta_bic: single.as_ref().map_or(0.0, |t| t.penalised_bic() - found.base.penalised_bic()),
            p_value: found.first_null_distribution.p_value(measured),
            detection_limit,
        }
    };
    let mut all: Vec<Outlook> = found.candidates.iter().zip(&found.singles).map(outlook).collect();
    all.sort_by(|a, b| a.delta_bic.total_cmp(&b.delta_bic));
    all
}
