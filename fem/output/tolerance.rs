//! What the drawing asks, and how the parts stand against it.

use serde_json::{Value as Json, json};

use super::json::finite;
use super::number;
use crate::process::Standing;

/// Most parts that are named.
const MOST_NAMED: usize = 6;

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
