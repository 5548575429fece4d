//! Intervals of parameters over all sets that may be true (Bayesian model averaging; Hoeting, Madigan, Raftery and
//! Volinsky 1999): that of one set holds the truth only where this set is the true one.

use std::f64::consts::SQRT_2;

use nalgebra::DVector;
use statrs::function::erf::erfc;

use super::candidate_model::CandidateModel;
use super::laplace;
use super::search::SearchResult;
use crate::fit::{Estimate, Interval, Usual};

/// Widths from a centre beyond which nothing is left.
const FAR: f64 = 9.0;
/// Logarithm of the largest ratio to its centre at which a size is looked for.
const DECADES: f64 = 20.0;
/// Bisections of a quantile: as many as a double has digits.
const BISECTIONS: usize = 60;

/// A parameter in one set: its search variable, normal about a centre, with a width of its own on either side.
#[derive(Clone, Debug)]
struct Component {
    weight: f64,
    centre: f64,
    below: f64,
    above: f64,
    /// Whether its logarithm is normal: a size never changes its sign.
    is_size: bool,
}

impl Component {
    /// Share of its weight at or below `s`.
    fn cumulative(&self, s: f64) -> f64 {
        let width = if s < self.centre { self.below } else { self.above };
        let away = match self.is_size {
            true => (s / self.centre).max(0.0).ln() * self.centre,
            false => s - self.centre,
        };
        let z = if width > 0.0 { away / width } else { away.signum() * f64::INFINITY };
        0.5 * self.weight * if away == 0.0 { 1.0 } else { erfc(-z / SQRT_2) }
    }

    /// Values between which all of it lies that is bounded.
    fn ends(&self) -> (f64, f64) {
        let reach = |width: f64| if width.is_finite() { FAR * width } else { 0.0 };
        if !self.is_size {
            return (self.centre - reach(self.below), self.centre + reach(self.above));
        }
        let factor = |width: f64| (reach(width) / self.centre.abs()).min(DECADES).exp();
        let (one, other) = (self.centre * factor(self.above), self.centre / factor(self.below));
        (one.min(other), one.max(other))
    }
}

/// The other sets that may be true, each with its weight beside the best and what data and prior leave of its parameters.
pub struct Others<'r, 'a>(Vec<Other<'r, 'a>>);

struct Other<'r, 'a> {
    model: &'r CandidateModel<'a>,
    weight: f64,
    centre: DVector<f64>,
    spread: DVector<f64>,
}

impl<'r, 'a> Others<'r, 'a> {
    /// Those beside `best`; `None` where it was not visited, and so has no weight.
    pub fn beside(found: &'r SearchResult<'a>, best: &CandidateModel) -> Option<Self> {
        let other = |(model, weight): (&'r CandidateModel<'a>, f64)| {
            let left = laplace::left(model)?;
            Some(Other {
                model,
                weight,
                centre: &model.solution.position + left.step,
                spread: DVector::from_iterator(left.root.nrows(), left.root.row_iter().map(|row| row.norm())),
            })
        };
        Some(Self(found.beside(&best.members)?.filter_map(other).collect()))
    }

    /// Widens the interval of an estimate of the best set to that over all sets that have its parameter.
    pub fn widen(&self, estimate: &mut Estimate, best: &CandidateModel) {
        let path = &estimate.parameter.path;
        let place = |model: &CandidateModel| model.objective.parameters.iter().position(|p| p.path == *path);
        let Some(i) = place(best) else { return };
        let (variable, centre) = (&best.objective.variables[i], best.solution.position[i]);
        let turn = estimate.value - variable.value(centre);
        let period = best.objective.catalogue(i).and_then(|entry| Some(entry.kind.to_si(entry.period?)));
        let nearest = |s: f64| period.map_or(s, |period| s - period * ((s - centre) / period).round());
        let Interval { low, high } = estimate.interval;
        let ends = [low, high].map(|end| end.map(|value| variable.position(value - turn)));
        let [low, high] = if variable.is_reversed() { [ends[1], ends[0]] } else { ends };
        let width = |end: Option<f64>| end.map_or(f64::INFINITY, |end| (end - centre).abs() / Interval::HALF);
        let mut components =
            vec![Component { weight: 1.0, centre, below: width(low), above: width(high), is_size: false }];
        components.extend(self.0.iter().filter_map(|other| {
            let own = place(other.model)?;
            let (centre, spread) = (nearest(other.centre[own]), other.spread[own]);
            let is_size = matches!(other.model.objective.variables[own].usual, Some(Usual::Size { .. }));
            Some(Component { weight: other.weight, centre, below: spread, above: spread, is_size })
        }));
        if components.len() == 1 {
            return;
        }
        let end = |share: f64| quantile(&components, share).filter(|s| (variable.low..=variable.high).contains(s));
        let ends = [end(0.025), end(0.975)];
        let [low, high] = if variable.is_reversed() { [ends[1], ends[0]] } else { ends };
        let value = |end: Option<f64>| end.map(|s| variable.value(s) + turn);
        estimate.interval = Interval { low: value(low), high: value(high) };
        estimate.std = estimate.interval.std().map_or(estimate.std, |std| estimate.std.max(std));
    }
}

/// The search variable below which this share of the weight lies; `None` where the share lies beyond everything that is
/// bounded.
fn quantile(components: &[Component], share: f64) -> Option<f64> {
    let whole: f64 = components.iter().map(|own| own.weight).sum();
    let below = |s: f64| components.iter().map(|own| own.cumulative(s)).sum::<f64>() / whole;
    let (mut low, mut high) = components
        .iter()
        .map(Component::ends)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (from, to)| (low.min(from), high.max(to)));
    let margin = f64::EPSILON * (low.abs() + high.abs());
    (low, high) = (low - margin, high + margin);
    if below(low) > share || below(high) < share {
        return None;
    }
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if below(middle) < share { low = middle } else { high = middle }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::{Component, quantile};

    fn normal(weight: f64, centre: f64, width: f64) -> Component {
        Component { weight, centre, below: width, above: width, is_size: false }
    }

    /// Quantiles of the standard normal distribution from tables: 95 % 1.644854, 97.5 % 1.959964, 90 % 1.281552.
    #[test]
    fn quantiles_of_mixtures() {
        let alone = vec![normal(3.0, 2.0, 0.5)];
        let far_apart = vec![normal(1.0, 0.0, 1.0), normal(1.0, 100.0, 2.0)];
        let unequal = vec![normal(3.0, 0.0, 1.0), normal(1.0, 100.0, 1.0)];
        let point = vec![normal(0.5, 3.0, 0.0), normal(0.5, 9.0, 0.0)];
        let below_nothing = |weight| Component { below: f64::INFINITY, ..normal(weight, 0.0, 1.0) };
        let open = vec![below_nothing(1.0), normal(3.0, 5.0, 0.1)];
        let hardly_open = vec![below_nothing(0.04), normal(0.96, 5.0, 0.1)];
        // ln |s| with a standard deviation of one.
        let sizes = [1.0, -1.0].map(|sign| vec![Component { is_size: true, ..normal(1.0, 2.0 * sign, 2.0) }]);
        for (components, share, expected) in [
            (&alone, 0.975, Some(2.0 + 0.5 * 1.959_964)),
            (&alone, 0.5, Some(2.0)),
            (&far_apart, 0.025, Some(-1.644_854)),
            (&far_apart, 0.975, Some(100.0 + 2.0 * 1.644_854)),
            (&unequal, 0.975, Some(100.0 + 1.281_552)),
            (&point, 0.025, Some(3.0)),
            (&point, 0.975, Some(9.0)),
            (&sizes[0], 0.025, Some(2.0 * (-1.959_964f64).exp())),
            (&sizes[1], 0.025, Some(-2.0 * 1.959_964f64.exp())),
            (&open, 0.025, None),
            // Half of 0.04 lies nowhere; three quarters of it lie up to 0.674490 above.
            (&hardly_open, 0.03, Some(0.674_490)),
        ] {
            let found = quantile(components, share);
            match (found, expected) {
                (Some(found), Some(expected)) => assert!((found - expected).abs() < 1e-5, "{components:?} {found}"),
                (found, expected) => assert_eq!(found, expected, "{components:?}"),
            }
        }
    }
}
