//! From what the search found to what is said.

use super::classes::{self, Place};
use super::contradiction::Contradiction;
use super::ground::Ground;
use super::held_out::Folds;
use super::price::Yardstick;
use super::search::{self, Found, SIGNIFICANCE};
use super::trial::Trial;
use super::verdict::{self, State, Verdict};
use super::visibility::visibility;
use super::{Diagnosis, Missing, Outlook, next, signature, unsolvable, yardstick};
use crate::fit::{self, Fit, Patience, minimise};
use crate::measure::Repeats;
use crate::process::Failure;

/// What is to be said of a search.
///
/// # Errors
/// The model cannot be computed beside its best values.
pub fn conclude(found: Found, repeats: &Repeats, contradictions: &[Contradiction]) -> Result<Diagnosis, Failure> {
    let yardstick = yardstick(&found.base.objective.noise, repeats);
    let folds = Folds::of(&found.base);
    let mut best = found.best().clone();
    best.solution =
        minimise(&mut best.objective, &best.solution.position, &[], Patience::FULL).ok_or_else(unsolvable)?;
    let mut settled = fit::settle(&mut best.objective, best.solution)?;
    best.solution = settled.solution.clone();
    let state = |trial: &Trial| State::of(trial, repeats, folds.as_ref());
    let (before, mut after) = (state(&found.base), state(&best));
    let features = verdict::features(&found.base);
    let mut remaining = if best.members.is_empty() { features.clone() } else { verdict::features(&best) };
    let verdict = verdict::verdict(&found.base, &best, (&before, &features), (&after, &remaining));
    if verdict == Verdict::Unexplained {
        best = found.base.clone();
        settled = fit::settle(&mut best.objective, best.solution.clone())?;
        after = before.clone();
        remaining = features.clone();
    }
    let fit = fit::report(&best.objective, settled, repeats);
    let places = if best.members.is_empty() { Vec::new() } else { classes::places(&found) };
    let missing = missing(&found, &best, &fit, yardstick, &places, &state);
    let next = next::next(&found, &best, &places);
    let all = found.tried.iter().chain([&found.base, &best]);
    let trials = all.fold((0, 0), |(f, e), t| (f + t.objective.failures, e + t.objective.evaluations));
    let candidates = outlooks(&found, &best, yardstick);
    Ok(Diagnosis {
        rows: found.base.objective.measurements.len(),
        cautions: cautions(&found, repeats, verdict, contradictions),
        noise: found.base.objective.noise.level(found.base.objective.measurements),
        before,
        features,
        verdict,
        missing,
        after,
        fit,
        remaining,
        candidates,
        next,
        held_out_by: folds.map(|f| f.coordinate),
        trials,
    })
}

/// What limits any diagnosis of these data.
fn cautions(found: &Found, repeats: &Repeats, verdict: Verdict, contradictions: &[Contradiction]) -> Vec<String> {
    let base = &found.base;
    let measurements = base.objective.measurements;
    let coordinates = base.objective.model.process.coordinates();
    let varies = |i: &usize| {
        let column = &measurements.rows.columns[*i];
        !coordinates[*i].repeats && column.iter().any(|v| *v != column[0])
    };
    let mut cautions: Vec<String> = contradictions.iter().map(Contradiction::text).collect();
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
    let left = matches!(verdict, Verdict::PartlyExplained | Verdict::Unexplained);
    if left && found.steps.len() == found.most && found.most < found.candidates.len() {
        let most = found.most;
        cautions.push(format!("no more than {most} effects were looked for together; --max-effects looks for more"));
    }
    cautions
}

/// The effects of the best set, the most needed first, each with those that could stand in its place.
fn missing(
    found: &Found,
    best: &Trial,
    fit: &Fit,
    yardstick: Yardstick,
    places: &[Place],
    state: &dyn Fn(&Trial) -> State,
) -> Vec<Missing> {
    let mut list = Vec::new();
    let mut rest = best.clone();
    while !rest.members.is_empty() {
        let smaller = rest
            .members
            .iter()
            .filter_map(|m| search::without(&found.base, &found.candidates, &rest, *m).map(|t| (*m, t)));
        let Some((last, next)) = smaller.min_by(|a, b| a.1.solution.chi2.total_cmp(&b.1.solution.chi2)) else { break };
        let place = places.iter().find(|p| p.candidate == last);
        let gained = place.map_or(0.0, |p| p.without - best.solution.chi2);
        let measured = yardstick.measure(gained, best.solution.chi2, best.objective.freedom());
        let effect = found.candidates[last].effect;
        let prefix = format!("effects.{}.", effect.name);
        list.push(Missing {
            effect,
            state: state(&rest),
            p_value: found.price.p_value(measured),
            estimates: fit.estimates.iter().filter(|e| e.parameter.path.starts_with(&prefix)).cloned().collect(),
            indistinguishable_from: place
                .map_or(Vec::new(), |p| p.rivals.iter().map(|r| found.candidates[r.candidate].effect).collect()),
        });
        rest = next;
    }
    list.reverse();
    list
}

/// What the data say of every effect that is not there.
fn outlooks(found: &Found, best: &Trial, yardstick: Yardstick) -> Vec<Outlook> {
    let ground = Ground::new(&mut best.objective.clone(), &best.solution);
    let threshold = found.price.quantile(SIGNIFICANCE);
    let outlook = |(candidate, single): (&signature::Candidate, &Option<Trial>)| {
        let visibility = ground.as_ref().and_then(|g| visibility(g, candidate, threshold));
        let gained = single.as_ref().map_or(0.0, |t| found.base.solution.chi2 - t.solution.chi2);
        let measured =
            single.as_ref().map_or(0.0, |t| yardstick.measure(gained, t.solution.chi2, t.objective.freedom()));
        Outlook {
            effect: candidate.effect,
            rms: single.as_ref().map(verdict::rms),
            delta_bic: single.as_ref().map_or(0.0, |t| t.score() - found.base.score()),
            p_value: found.first_price.p_value(measured),
            visibility,
        }
    };
    let mut all: Vec<Outlook> = found.candidates.iter().zip(&found.singles).map(outlook).collect();
    all.sort_by(|a, b| a.delta_bic.total_cmp(&b.delta_bic));
    all
}
