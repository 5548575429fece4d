//! The verdict in plain words, with the fall of the error.

use super::kinds::{Kinds, is_grouped};
use super::words::label;
use crate::compare::Judges;
use crate::diagnose::{Cause, Diagnosis, GoodnessOfFit, Group, Missing, Verdict};
use crate::model::Data;
use crate::output::comparison::not_judged;
use crate::output::listing::listed;

/// Most observables of which the error is told one by one; of more it is told in standard uncertainties.
const EACH: usize = 2;
/// Part of the error that must be gone to be told as its fall.
const NOTABLE: f64 = 0.05;
/// Most members of a group that are named in the verdict.
const FEW: usize = 3;

/// The verdict as a sentence, for text and page.
pub fn verdict(data: &Data, d: &Diagnosis) -> String {
    let them = match &d.missing[..] {
        [one] if !is_grouped(d, &one.effect) => "it",
        _ => "them",
    };
    match d.verdict {
        Verdict::Adequate if d.released.is_empty() => {
            "nothing is missing: the noise explains what the model leaves".into()
        }
        Verdict::Adequate => {
            let (paths, are) = (d.released.join(", "), if d.released.len() == 1 { "is" } else { "are" });
            let fall = fall(data, d).map_or(String::new(), |fall| format!(": {fall}, down to the noise"));
            format!("nothing else is missing once {paths} {are} taken as unknown{fall}")
        }
        Verdict::NotJudged => {
            let left = errors(data, &d.before);
            if data.are_all_alike() {
                return format!("{}, and the model is off by {left}", not_judged(data));
            }
            if data.uncertainty.is_some() {
                let rows =
                    if data.len() == 1 { "one row tells".to_string() } else { format!("{} rows tell", data.len()) };
                return format!(
                    "not judged: {rows} no cause from another: the model is off by {left}; measure at further places"
                );
            }
            format!("{}: the model is off by {left}; repeat rows, or give the column", not_judged(data))
        }
        Verdict::MissingEffect => match fall(data, d) {
            Some(fall) => format!("missing: {}; with {them} {fall}, down to the noise", names(d)),
            None => {
                let left = errors(data, &d.after);
                format!("missing: {}; with {them} the noise explains the error of {left}", names(d))
            }
        },
        Verdict::PartlyExplained => {
            let is_noise = d.remaining.is_empty() && d.suspects.is_empty() && d.after.is_as_noise();
            let left = match d.missing.iter().any(Missing::describes) {
                _ if !is_noise => "structure remains",
                true => "part of that is described, not explained",
                false => "what is found is in doubt",
            };
            let fall = fall(data, d).map_or(String::new(), |fall| format!(" with {them} {fall}, and"));
            format!("partly explained: {};{fall} {left}", names(d))
        }
        Verdict::Unexplained if d.missing.iter().any(is_law) => {
            let fall = fall(data, d).unwrap_or_else(|| format!("the model is off by {}", errors(data, &d.after)));
            let left = match d.verdict_after {
                Verdict::Adequate => "down to the noise",
                _ => "and structure remains",
            };
            let none = no_cause(data, d);
            format!("unexplained: {none}, but {} describes it; with {them} {fall}, {left}", names(d))
        }
        Verdict::Unexplained => {
            let left = errors(data, &d.before);
            format!("unexplained: the model is off by {left}, and {}", no_cause(data, d))
        }
    }
}

/// What is said of the effects none of which is the cause; of those that were not tried nothing is.
fn no_cause(data: &Data, d: &Diagnosis) -> &'static str {
    match d.judges {
        _ if !data.progress.left_undone().is_empty() => {
            "no cause was found in the time, which was over before all effects were tried"
        }
        Judges::Wrong => "rows at so few places, and no column u, tell no cause",
        Judges::Nothing | Judges::Both => "no effect known here is the cause",
    }
}

/// Whether it describes what is left as a law does, of the rows or of the sensor that shows them.
fn is_law(missing: &Missing) -> bool {
    matches!(missing.cause, Cause::Law(_)) || missing.effect.parameters.iter().any(|p| p.over.is_some())
}

/// Names of what is told: the certain ones, how many of each group, and what may be there.
fn names(d: &Diagnosis) -> String {
    let kinds = Kinds::of(d);
    let name = |m: &&Missing| match m.cause {
        Cause::Law(_) => format!("a {}", label(m)),
        _ => m.effect.name.to_string(),
    };
    let own = kinds.certain.iter().chain(&kinds.described).map(name);
    let is_told = |group: &&Group| d.missing.iter().any(|m| group.effects.contains(&m.effect.name));
    let groups = d.posterior.groups.iter().filter(is_told).map(some_of);
    let perhaps: Vec<&str> = kinds.perhaps.iter().map(|m| &*m.effect.name).collect();
    let perhaps = (!perhaps.is_empty()).then(|| format!("perhaps {}", perhaps.join(", ")));
    own.chain(groups).chain(perhaps).collect::<Vec<_>>().join(", ")
}

/// How many effects are told, each kind by itself: what stands for another counts once.
pub fn counted(d: &Diagnosis) -> String {
    let kinds = Kinds::of(d);
    let is_told = |group: &&Group| d.missing.iter().any(|m| group.effects.contains(&m.effect.name));
    let groups = d.posterior.groups.iter().filter(is_told);
    let of_group = groups.map(|group| format!("{} of {}", group.at_least, group.effects.len()));
    let some = |number: usize, word: &str| (number > 0).then(|| format!("{number} {word}"));
    let certain = some(kinds.certain.len(), "certain").into_iter().chain(of_group);
    let others = [some(kinds.described.len(), "described"), some(kinds.perhaps.len(), "perhaps")];
    let all: Vec<String> = certain.chain(others.into_iter().flatten()).collect();
    if all.is_empty() { "none".into() } else { all.join(", ") }
}

/// How many of a group are there.
fn some_of(group: &Group) -> String {
    match group.effects.len() {
        few if few <= FEW => format!("at least {} of {}", group.at_least, listed(&group.effects, FEW)),
        many => format!("at least {} of a group of {many}", group.at_least),
    }
}

/// The fall of the error from the model to that with all that is missing; `None` where it hardly falls.
fn fall(data: &Data, d: &Diagnosis) -> Option<String> {
    if d.after.rms > (1.0 - NOTABLE) * d.before.rms {
        return None;
    }
    let fall = |[before, after, unit]: [String; 3]| format!("from {before} to {after} {unit}");
    let all: Vec<String> =
        each(data, &d.before).zip(each(data, &d.after)).map(|(a, b)| fall([a.0, b.0, b.1])).collect();
    Some(format!("the error falls {}", all.join(" and ")))
}

/// What a model leaves, in words.
fn errors(data: &Data, goodness: &GoodnessOfFit) -> String {
    each(data, goodness).map(|(value, unit)| format!("{value} {unit}")).collect::<Vec<_>>().join(" and ")
}

/// Root mean square error of each observable with its unit, or of all together where there are many.
fn each(data: &Data, goodness: &GoodnessOfFit) -> impl Iterator<Item = (String, String)> {
    let all = match data.observables.len() {
        2..=EACH => data.observables.iter().map(|seen| seen.kind).zip(goodness.rms_of.iter().copied()).collect(),
        _ => vec![(data.kind(), goodness.rms)],
    };
    all.into_iter().map(|(kind, rms)| (format!("{:.3}", kind.from_si(rms)), kind.unit.to_string()))
}
