//! What these data could have shown: the smallest size of each effect that would stand out.

use super::ground::Ground;
use super::signature::{Candidate, Variant};
use crate::process::Neutral;

/// An effect is seen in nine cases of ten when its signature exceeds the threshold by this many standard uncertainties.
const NINE_OF_TEN: f64 = 1.2816;
/// Less than this part of a signature is left when what the model's own freedom can imitate is taken out: it cannot be seen.
const HIDDEN: f64 = 0.05;

/// How visible an effect is.
#[derive(Clone, Debug, PartialEq)]
pub struct Visibility {
    /// The parameter that tells its size.
    pub parameter: &'static str,
    /// Smallest value that would have been seen, canonical unit; for a stiffness the largest. Of a shape in the middle of what is plausible: half show more, half less.
    pub smallest: Option<f64>,
    /// Part of the signature that the model's own free parameters cannot imitate.
    pub own: f64,
    /// Whether the data could show it at all at a plausible size.
    pub visible: bool,
}

/// How visible an effect is on a ground, where a gain must exceed `threshold` to be believed.
pub fn visibility(ground: &Ground, candidate: &Candidate, threshold: f64) -> Option<Visibility> {
    // Of several switches the one that shows most at a usual size, of all shapes the one in the middle: half show more, half less.
    let of_variant = |v: &Variant| {
        let sizes = v.switches.iter().zip(v.columns.column_iter()).map(|(switch, column)| {
            let own = ground.project(column.into_owned()).norm();
            (*switch, column.norm(), own)
        });
        sizes.max_by(|a, b| (a.2 * a.0.size).total_cmp(&(b.2 * b.0.size)))
    };
    let mut shapes: Vec<_> = candidate.variants.iter().filter_map(of_variant).collect();
    shapes.sort_by(|a, b| (a.2 * a.0.size).total_cmp(&(b.2 * b.0.size)));
    let (switch, whole, left) = shapes.get(shapes.len() / 2).copied()?;
    let entry = &candidate.effect.parameters[switch.parameter];
    let own = if whole > 0.0 { left / whole } else { 0.0 };
    let least = (threshold.sqrt() + NINE_OF_TEN) / left;
    let least = switch.value(least);
    let value = if entry.neutral == Neutral::Infinity { 1.0 / least } else { least };
    let shown = entry.kind.from_si(value);
    let reachable = match entry.neutral {
        Neutral::Infinity => shown > entry.range.0,
        Neutral::Value(_) | Neutral::Shape => shown < entry.range.1,
    };
    let visible = own >= HIDDEN && reachable && shown.is_finite();
    Some(Visibility { parameter: entry.name, smallest: shown.is_finite().then_some(shown), own, visible })
}
