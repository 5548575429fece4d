//! Intervals of wrong values over the sets: where several sets fit, the interval of a value within the best of them is too
//! narrow, for another cause beside it moves it.

use super::laplace;
use super::search::SearchResult;
use crate::fit::{Estimate, Interval};
use crate::process::ON_TRIAL;

/// Probability on either side of an interval of 95 %.
const TAIL: f64 = 0.025;
/// Halvings by which a quantile is found.
const HALVINGS: usize = 60;

/// Widens the intervals of values on trial to what all credible sets that hold them say together: a mixture of normal
/// distributions of the search variable, by the weights of the sets.
pub fn widen(estimates: &mut [Estimate], found: &SearchResult) {
    let on_trial = found.candidates.iter().filter(|candidate| candidate.effect.table == ON_TRIAL);
    for candidate in on_trial {
        let path = &*candidate.effect.name;
        let Some(estimate) = estimates.iter_mut().find(|e| e.parameter.path == *path) else { continue };
        let Some([low, high]) = interval(path, found) else { continue };
        let Interval { low: own_low, high: own_high } = estimate.interval;
        estimate.interval = Interval { low: own_low.map(|own| own.min(low)), high: own_high.map(|own| own.max(high)) };
    }
}

/// A normal distribution with its weight.
struct Normal {
    weight: f64,
    mean: f64,
    std: f64,
}

/// 95 % interval of a value over the credible sets, SI.
fn interval(path: &str, found: &SearchResult) -> Option<[f64; 2]> {
    let credible = found.credible();
    let best = credible.first()?.criterion;
    let mut variable = None;
    let mut parts: Vec<Normal> = Vec::new();
    for set in credible {
        let (objective, position) = (&set.model.objective, &set.model.solution.position);
        let Some(own) = objective.parameters.iter().position(|p| p.path == *path) else { continue };
        let Some(left) = laplace::left(&set.model) else { continue };
        let (mean, std) = (position[own] + left.step[own], left.root.row(own).norm());
        parts.push(Normal { weight: laplace::weight(set.criterion, best), mean, std });
        variable = Some(&objective.variables[own]);
    }
    let variable = variable?;
    let ends = [TAIL, 1.0 - TAIL].map(|part| variable.value(quantile(&parts, part)));
    Some([ends[0].min(ends[1]), ends[0].max(ends[1])])
}

/// The place below which a part of a mixture lies.
fn quantile(parts: &[Normal], part: f64) -> f64 {
    /// Standard deviations beyond which nothing lies.
    const FAR: f64 = 8.0;
    let whole: f64 = parts.iter().map(|p| p.weight).sum();
    let share = |p: &Normal, at: f64| p.weight * lower_tail((at - p.mean) / p.std.max(f64::MIN_POSITIVE));
    let below = |at: f64| parts.iter().map(|p| share(p, at)).sum::<f64>();
    let mut low = parts.iter().map(|p| p.mean - FAR * p.std).fold(f64::INFINITY, f64::min);
    let mut high = parts.iter().map(|p| p.mean + FAR * p.std).fold(f64::NEG_INFINITY, f64::max);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if below(middle) < part * whole { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// Part of the standard normal distribution below z.
fn lower_tail(z: f64) -> f64 {
    0.5 * statrs::function::erf::erfc(-z / std::f64::consts::SQRT_2)
}

#[cfg(test)]
mod tests {
    use super::{Normal, quantile};

    #[test]
    fn quantiles_of_mixtures() {
        let normal = |weight, mean| Normal { weight, mean, std: 1.0 };
        let of_one = quantile(&[normal(3.0, 2.0)], 0.975);
        assert!((of_one - 3.959_964).abs() < 1e-5, "{of_one}");
        // Half of each of two that are far apart: their middle is the place of equal parts, and a twentieth of one lies below
        // a fortieth of both.
        let two = [normal(1.0, -50.0), normal(1.0, 50.0)];
        let low = quantile(&two, 0.025);
        assert!((low + 50.0 + 1.644_854).abs() < 1e-5, "{low}");
    }
}
