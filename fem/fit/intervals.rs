//! 95 % intervals from the profile of χ²: how far a parameter can be moved, all others following, before χ² has risen by the
//! quantile. Curvature alone misjudges time constants, exponents and whatever is near a bound.

use nalgebra::DMatrix;
use statrs::distribution::{ContinuousCDF, FisherSnedecor};

use super::least_squares::{Patience, minimise};
use super::objective::{Objective, Solution};
use crate::compare::NoiseSource;

/// 95 % point of χ² with one degree of freedom.
const QUANTILE: f64 = 3.841_458_820_694_124;
/// Distance from the quantile, in √χ², at which an end is found.
const PRECISION: f64 = 0.02;

/// How the other parameters follow one that is held.
const FOLLOW: Patience = Patience { steps: 8, fall: 1e-10 };

/// A 95 % interval, SI; an open end is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Lower end.
    pub low: Option<f64>,
    /// Upper end.
    pub high: Option<f64>,
}

/// The interval of every parameter.
pub fn profile(objective: &mut Objective, best: &Solution, covariance: &DMatrix<f64>) -> Vec<Interval> {
    let quantile = quantile(objective);
    (0..objective.axes.len())
        .map(|i| {
            let std = covariance[(i, i)].sqrt();
            let mut end = |direction: f64| {
                let found = end(objective, best, i, direction * std, quantile);
                found.map(|s| objective.axes[i].value(s)).filter(|v| v.is_finite())
            };
            let (down, up) = (end(-1.0), end(1.0));
            if objective.axes[i].is_reversed() {
                Interval { low: up, high: down }
            } else {
                Interval { low: down, high: up }
            }
        })
        .collect()
}

/// With an estimated noise χ² is measured by what the fit leaves, and the quantile is that of F.
fn quantile(objective: &Objective) -> f64 {
    let freedom = objective.freedom().max(1.0);
    match objective.noise.source {
        NoiseSource::Column => QUANTILE,
        NoiseSource::Repeats | NoiseSource::Estimated => {
            FisherSnedecor::new(1.0, freedom).map_or(QUANTILE, |f| f.inverse_cdf(0.95))
        }
    }
}

/// The end in one direction, in the search variable: √Δχ² is nearly linear in it, so that secants find it in a few steps.
fn end(objective: &mut Objective, best: &Solution, i: usize, std: f64, quantile: f64) -> Option<f64> {
    let target = quantile.sqrt();
    let axis = objective.axes[i].clone();
    let origin = best.position[i];
    let mut follow = best.position.clone();
    let mut rise = |s: f64| {
        let mut start = follow.clone();
        start[i] = s;
        let moved = minimise(objective, &start, &[i], FOLLOW)?;
        follow = moved.position.clone();
        Some((moved.chi2 - best.chi2).max(0.0).sqrt())
    };
    let (mut inner, mut inner_rise) = (origin, 0.0);
    let mut outer: Option<(f64, f64)> = None;
    // How often in a row a secant has stayed inside.
    let mut inside = 0;
    let mut next = origin + std * target;
    for _ in 0..16 {
        let s = next.clamp(axis.low, axis.high);
        if s == inner {
            return None;
        }
        let risen = rise(s)?;
        if (risen - target).abs() <= PRECISION {
            return Some(s);
        }
        if risen > target {
            outer = Some((s, risen));
            inside = 0;
        } else {
            (inner, inner_rise) = (s, risen);
            inside += 1;
            if outer.is_none() && (s == axis.low || s == axis.high) {
                // The bound itself is still inside: the end is open there.
                return None;
            }
        }
        next = match outer {
            Some((s, risen)) => {
                // A valley that is long and flat and then steep holds every secant back.
                let part = if inside > 1 { 0.5 } else { (target - inner_rise) / (risen - inner_rise) };
                inner + (s - inner) * part.clamp(0.1, 0.9)
            }
            None => {
                let slope = (inner_rise / (inner - origin)).abs().max(1e-3 / std.abs());
                let far = (target * 1.05 / slope).min(4.0 * (inner - origin).abs());
                origin + far.max(1.3 * (inner - origin).abs()) * std.signum()
            }
        };
    }
    outer.map(|o| o.0)
}
