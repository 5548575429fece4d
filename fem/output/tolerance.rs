//! What the drawing asks, and how the parts stand against it.

use serde_json::{Value as Json, json};

use super::json::finite;
use super::number;
use crate::knowledge::Probability;
use crate::process::Standing;
use crate::tolerance::Limits;
use crate::units::MICRO;

/// Most parts that are named.
const MOST_NAMED: usize = 6;
/// Coverage factor of an expanded uncertainty.
const COVERAGE: f64 = 2.0;

/// A line for each requirement: its limits, how many parts keep them, and how far the others are out.
pub fn lines(standings: &[Standing]) -> Vec<String> {
    standings.iter().map(line).collect()
}

fn line(standing: &Standing) -> String {
    let Standing { requirement, parts } = standing;
    let (limits, kind) = (requirement.limits, requirement.kind);
    let [low, high] = standing.range();
    let shown = |si: f64| number::trimmed(kind.from_si(si), 2);
    let (asked, found) = if limits.lower.is_finite() {
        (format!("{} to {}", shown(limits.lower), shown(limits.upper)), format!("{} to {}", shown(low), shown(high)))
    } else {
        (format!("up to {}", shown(limits.upper)), format!("up to {}", shown(high)))
    };
    let out: Vec<Option<usize>> = standing.out().collect();
    let by = (limits.lower - low).max(high - limits.upper);
    let verdict = match (out.len(), parts.len()) {
        (0, _) => "within".to_string(),
        (_, 1) => format!("out by {}", shown(by)),
        (out_of, all) if out_of == all => format!("every part out, by up to {}", shown(by)),
        _ => format!("out by up to {}: {}", shown(by), named(&out)),
    };
    format!("{} ({asked} {unit}): {found} {unit}, {verdict}", requirement.label, unit = kind.unit)
}

fn named(out: &[Option<usize>]) -> String {
    let numbers: Vec<String> = out.iter().flatten().take(MOST_NAMED).map(ToString::to_string).collect();
    let more = out.len().saturating_sub(numbers.len());
    let parts = if out.len() == 1 { "part" } else { "parts" };
    let and_more = if more > 0 { format!(" and {more} more") } else { String::new() };
    format!("{parts} {}{and_more}", numbers.join(", "))
}

/// Says how many parts a measurement of such a standard uncertainty proves neither in nor out of their limits, the expanded
/// uncertainty being twice that (ISO 14253-1).
pub fn open(standings: &[Standing], uncertainty: f64) -> Option<String> {
    let expanded = COVERAGE * uncertainty;
    let is_open = |standing: &&Standing, range: &[f64; 2]| {
        let limits = standing.requirement.limits;
        let narrowed = Limits { lower: limits.lower + expanded, upper: limits.upper - expanded };
        let widened = Limits { lower: limits.lower - expanded, upper: limits.upper + expanded };
        widened.hold(*range) && !narrowed.hold(*range)
    };
    // Forms are differences, of which this uncertainty is none.
    let of_sizes = standings.iter().filter(|own| own.requirement.limits.lower.is_finite());
    let mut open: Vec<Option<usize>> = of_sizes
        .flat_map(|own| own.parts.iter().filter(move |(_, range)| is_open(&own, range)).map(|(part, _)| *part))
        .collect();
    open.sort_unstable();
    open.dedup();
    let kind = standings.first().map_or(MICRO, |own| own.requirement.kind);
    let told = number::trimmed(kind.from_si(expanded), 2);
    let who = match &open[..] {
        [] => return None,
        [None] => "it is".to_string(),
        [_] => format!("{} is", named(&open)),
        _ => format!("{} are", named(&open)),
    };
    Some(format!(
        "{who} neither proven in nor out: within \u{b1}{told} {} of a limit (ISO 14253-1, U = 2\u{b7}u)",
        kind.unit
    ))
}

/// With which probability everything is within.
pub fn probability(own: &Probability) -> String {
    if own.of_parts.iter().all(|(_, within)| *within == 0.0) {
        return if own.of_parts.len() > 1 { "no part is ever within" } else { "it is never within" }.into();
    }
    let least = own.of_parts.iter().filter(|_| own.of_parts.len() > 1).min_by(|a, b| a.1.total_cmp(&b.1));
    let of_least = least.and_then(|(part, p)| Some(format!("; part {} with {:.0} %", (*part)?, 100.0 * p)));
    format!(
        "{} within with a probability of {:.0} %{}",
        if own.of_parts.len() > 1 { "all parts are" } else { "it is" },
        100.0 * own.of_all,
        of_least.unwrap_or_default()
    )
}

/// With which probability each part is within.
pub fn parts(probability: Option<&Probability>) -> Json {
    let one = |(part, within): &(Option<usize>, f64)| json!({ "part": part, "probability_in": within });
    probability.map(|own| own.of_parts.iter().map(one).collect::<Vec<_>>()).into()
}

/// The requirements with their limits, what the parts show, and the parts that are out.
pub fn json(standings: &[Standing]) -> Json {
    let one = |standing: &Standing| {
        let Standing { requirement, parts } = standing;
        let of = |si: f64| finite(requirement.kind.from_si(si));
        json!({
            "requirement": requirement.key,
            "label": requirement.label,
            "lower": of(requirement.limits.lower),
            "upper": of(requirement.limits.upper),
            "unit": requirement.kind.unit,
            "parts": parts.len(),
            "range": standing.range().map(of),
            "out": standing.out().flatten().collect::<Vec<_>>(),
            "within": standing.out().next().is_none(),
        })
    };
    standings.iter().map(one).collect()
}
