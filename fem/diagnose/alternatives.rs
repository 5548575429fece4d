//! Other sets that explain the measurements as well as the one that is told, for a model that is written.

use super::candidate_model::CandidateModel;
use super::search::SearchResult;
use crate::input::ParameterId;
use crate::model::OtherSet;
use crate::noise::MEASUREMENT;
use crate::process::{Description, EFFECTS, Neutral};

/// Probability below which a set moves no interval of 95 %.
const LEAST: f64 = 0.02;
/// Most sets that a model tells.
const MOST: usize = 8;

/// The sets that may be true beside `best`, the most probable first; none where it was not visited itself.
pub fn alternatives(found: &SearchResult, best: &CandidateModel) -> Vec<OtherSet> {
    let others: Vec<(&CandidateModel, f64)> = found.beside(&best.members).into_iter().flatten().collect();
    let whole = 1.0 + others.iter().map(|(_, weight)| weight).sum::<f64>();
    // What changes along the parts is written in numbers of parts, of which one more or less is another machine.
    let is_plain = |set: &CandidateModel| set.objective.added.iter().all(|effect| effect.changes.is_none());
    let probable = others.into_iter().filter(|(set, weight)| is_plain(set) && *weight >= LEAST * whole);
    probable.take(MOST).map(|(set, weight)| other(set, best, weight / whole)).collect()
}

fn other(set: &CandidateModel, best: &CandidateModel, probability: f64) -> OtherSet {
    let objective = &set.objective;
    let is_own = |effect: &Description| objective.added.iter().any(|own| own.name == effect.name);
    let left_out = || best.objective.added.iter().filter(|effect| !is_own(effect));
    let without: Vec<String> =
        left_out().filter(|effect| effect.table == EFFECTS).map(|effect| effect.name.to_string()).collect();
    // A value that is not wrong in this set is the one that was written.
    let written = left_out().filter_map(|effect| match effect.parameters.first().map(|p| (p, p.neutral)) {
        Some((parameter, Neutral::Written(value, _))) => {
            Some((effect.path(parameter), format!("{value} {}", parameter.kind.unit)))
        }
        _ => None,
    });
    // What an instrument shows is no part of what is made.
    let is_made = |path: &ParameterId| !path.starts_with(MEASUREMENT);
    let values = objective.values(&set.solution.position);
    let values = objective.parameters.iter().zip(values).filter(|(own, _)| is_made(&own.path)).map(|(own, value)| {
        let text = format!("{:.7e} {}", own.kind.from_si(value), own.kind.unit);
        (own.path.clone(), text.trim_end().to_string())
    });
    OtherSet { probability, without, values: written.chain(values).collect() }
}
