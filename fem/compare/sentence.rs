//! A structure of the residual in one sentence.

use super::Trend;
use super::binning::Along;
use crate::process::Coordinate;
use crate::units::Kind;

/// The coordinates in words.
pub fn name(along: &Along, coordinates: &[Coordinate]) -> String {
    match &along.0[..] {
        [] => "everywhere".into(),
        several => several.iter().map(|i| &*coordinates[*i].name).collect::<Vec<_>>().join(" and "),
    }
}

/// The structure in one sentence.
pub fn sentence(
    along: &Along,
    coordinates: &[Coordinate],
    trend: Option<&Trend>,
    curve: &[(f64, f64)],
    kind: Kind,
) -> String {
    let observed = kind.unit;
    let Some(trend) = trend else {
        return match along.0.len() {
            0 => "the error is off by the same amount everywhere".into(),
            _ => format!("the error along {} changes with the other", name(along, coordinates)),
        };
    };
    let coordinate = &coordinates[along.0[0]];
    let along = coordinate.holds.kind().map(|k| k.unit).unwrap_or_default();
    let per = if along.is_empty() { coordinate.name.to_string() } else { along.to_string() };
    match *trend {
        Trend::Linear { slope } => {
            let word = if slope > 0.0 { "grows" } else { "falls" };
            let (from, to) = (curve.first().map_or(0.0, |p| p.0), curve.last().map_or(0.0, |p| p.0));
            let whole = (slope * (to - from)).abs();
            let size = slope.abs();
            format!(
                "the error {word} by {size:.3} {observed} per {per} along {}, {whole:.2} {observed} in all",
                coordinate.name
            )
        }
        Trend::Quadratic { height, at } => {
            let word = if height > 0.0 { "rises" } else { "sinks" };
            let size = height.abs();
            format!(
                "the error {word} in a bow of {size:.2} {observed} along {}, turning at {at:.1} {along}",
                coordinate.name
            )
            .trim_end()
            .into()
        }
        Trend::Step { height, at } => {
            format!("the error steps by {height:+.2} {observed} along {} at {at:.1} {along}", coordinate.name)
                .trim_end()
                .into()
        }
        Trend::Periodic { periods } => {
            format!("the error goes up and down along {}, {periods:.1} periods in all", coordinate.name)
        }
        Trend::Irregular => format!("the error varies along {}, like no line, bow or step", coordinate.name),
    }
}
