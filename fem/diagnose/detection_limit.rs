//! Detection limits: the smallest size of each effect that these data would have shown.

use super::residual_projection::ProjectedResidual;
use super::sensitivity::{CandidateEffect, Variant};
use crate::input::{Grows, Name};
use crate::process::{Neutral, Parameter};

/// Standard uncertainties by which a sensitivity must exceed the threshold for a detection in nine cases of
/// ten (power 0.9).
const NINE_OF_TEN: f64 = 1.2816;
/// Own share of a sensitivity below which the effect cannot be seen.
const HIDDEN: f64 = 0.05;

/// Detection limit of an effect.
#[derive(Clone, Debug, PartialEq)]
pub struct DetectionLimit {
    /// Linear parameter that tells its size.
    pub parameter: Name,
    /// Smallest value that would have been detected, canonical unit; for a stiffness the largest. It is the
    /// median over the grid of nonlinear parameters.
    pub smallest: Option<f64>,
    /// Part of the sensitivity that the model's own free parameters cannot imitate.
    pub own_share: f64,
    /// Whether the data could show the effect at a plausible size.
    pub detectable: bool,
}

/// Detection limit of an effect where Δχ² must exceed `threshold` to be significant.
pub fn detection_limit(
    projected: &ProjectedResidual,
    candidate: &CandidateEffect,
    threshold: f64,
) -> Option<DetectionLimit> {
    // Each variant counts by the linear parameter that shows most at a usual size; the median variant is
    // taken.
    let of_variant = |v: &Variant| {
        let sizes = v.linear.iter().zip(v.columns.column_iter()).map(|(parameter, column)| {
            let own = projected.project(column.into_owned()).norm();
            (*parameter, column.norm(), own)
        });
        sizes.max_by(|a, b| (a.2 * a.0.size).total_cmp(&(b.2 * b.0.size)))
    };
    let mut shapes: Vec<_> = candidate.variants.iter().filter_map(of_variant).collect();
    shapes.sort_by(|a, b| (a.2 * a.0.size).total_cmp(&(b.2 * b.0.size)));
    let (linear, whole, left) = shapes.get(shapes.len() / 2).copied()?;
    let entry = &candidate.effect.parameters[linear.parameter];
    let own_share = if whole > 0.0 { left / whole } else { 0.0 };
    let least = (threshold.sqrt() + NINE_OF_TEN) / left;
    let least = linear.value(least);
    let shown = shown(entry, least);
    let reachable = match entry.neutral {
        Neutral::Infinity => shown > entry.range.0,
        Neutral::Written(written, Grows::Inversely) => shown / written > entry.range.0 / written,
        Neutral::Written(_, Grows::Evenly) => shown < entry.range.1,
        Neutral::Written(written, Grows::Linearly | Grows::Otherwise) => shown / written < entry.range.1 / written,
        Neutral::Value(_) | Neutral::Shape => shown < entry.range.1,
    };
    let detectable = own_share >= HIDDEN && reachable && shown.is_finite();
    Some(DetectionLimit {
        parameter: entry.name.clone(),
        smallest: shown.is_finite().then_some(shown),
        own_share,
        detectable,
    })
}

/// Value of a parameter, in its canonical unit, at this distance of the search variable from where its effect vanishes.
fn shown(entry: &Parameter, distance: f64) -> f64 {
    match entry.neutral {
        Neutral::Infinity => entry.kind.from_si(1.0 / distance),
        Neutral::Value(neutral) => neutral + entry.kind.from_si(distance),
        Neutral::Written(written, Grows::Inversely) => written / (1.0 + distance),
        Neutral::Written(written, Grows::Linearly) => written * (1.0 + distance),
        // The search variable is the logarithm of the ratio.
        Neutral::Written(written, Grows::Otherwise) => written * distance.exp(),
        Neutral::Written(written, Grows::Evenly) => entry.kind.from_si(entry.kind.to_si(written) + distance),
        Neutral::Shape => entry.kind.from_si(distance),
    }
}

#[cfg(test)]
mod tests {
    use super::shown;
    use crate::fit::SearchVariable;
    use crate::input::{Bounds, Doubt, Grows};
    use crate::process::Parameter;
    use crate::units::{CONVECTION, TEMPERATURE};

    #[test]
    fn a_limit_of_a_value_stands_where_the_search_variable_has_its_distance() {
        for grows in [Grows::Linearly, Grows::Inversely, Grows::Otherwise] {
            let doubt = Doubt::by_factor(0.3, 3.0, grows, "");
            let entry = Parameter::doubted("film".into(), (CONVECTION, Bounds::Positive), 15.0, doubt);
            let position = SearchVariable::of_candidate(&entry, None).position(CONVECTION.to_si(shown(&entry, 0.4)));
            assert!((position - 0.4).abs() < 1e-12, "{grows:?}: {position}");
        }
        let doubt = Doubt::by_amount(0.3, 3.0, "");
        let entry = Parameter::doubted("room".into(), (TEMPERATURE, Bounds::Any), 293.15, doubt);
        assert!((shown(&entry, 1.5) - 21.5).abs() < 1e-9);
        let position = SearchVariable::of_candidate(&entry, None).position(TEMPERATURE.to_si(21.5));
        assert!((position - 1.5).abs() < 1e-9, "{position}");
    }
}
