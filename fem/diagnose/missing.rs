//! The effects that a search has found, each with what it gains, its values and what stands beside it.

use std::cell::LazyCell;

use super::candidate_model::CandidateModel;
use super::change;
use super::confounding::Confounding;
use super::diagnosis::Missing;
use super::findings;
use super::judge::Judge;
use super::largest_change::{LargestChange, Tangent};
use super::lead;
use super::model_average::Others;
use super::null_distribution::{MaxStatistic, Variance};
use super::posterior::Posterior;
use super::residual_projection::ProjectedResidual;
use super::screening::Screening;
use super::search::SearchResult;
use super::sensitivity::CandidateEffect;
use crate::fit::{Estimate, Fit, StoppingCriterion, minimise};
use crate::input::ParameterId;
use crate::process::Description;

/// Lists the effects of the best model, the most needed first, each with its alternatives.
pub fn missing(
    found: &SearchResult,
    best: &CandidateModel,
    fit: &Fit,
    confoundings: &[Confounding],
    (judge, posterior): (&Judge, &Posterior),
) -> Vec<Missing> {
    let mut list = Vec::new();
    let variance = judge.variance;
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
            goodness: judge.goodness(&rest),
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
