//! Makes the estimates that the user sees, with warnings.

use nalgebra::DMatrix;

use super::intervals::Interval;
use super::objective::{Objective, Solution};
use super::told_together::{Combination, is_idle};
use crate::input::Parameter;

/// A fitted parameter. SI units.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Estimate {
    /// Parameter that was fitted.
    pub parameter: Parameter,
    /// Best value.
    pub value: f64,
    /// Standard uncertainty from the curvature of χ².
    pub std: f64,
    /// Profile-likelihood interval of 95 %; an end is open where the data do not close it.
    pub interval: Interval,
    /// Cautions for the user.
    pub warnings: Vec<String>,
    /// Profile of χ² as far as it was walked: values (SI), rising, the best one among them, with the rise of χ² there.
    pub profile: Vec<(f64, f64)>,
}

impl Estimate {
    /// Whether the data close the interval on both sides.
    pub fn is_closed(&self) -> bool {
        self.interval.low.is_some() && self.interval.high.is_some()
    }
}

/// Fewest standard deviations, all rows together, by which a parameter must move the prediction over its
/// usual size; below it the data cannot see the parameter.
const UNSEEN: f64 = 0.3;
/// Number of prior standard uncertainties beyond which a value conflicts with its prior.
const CONFLICTING: f64 = 4.0;
/// Part of the prior uncertainty above which the data have hardly sharpened the prior.
const UNSHARPENED: f64 = 0.95;

/// Relative difference that is round-off.
const ROUND_OFF: f64 = 1e-9;

/// Whether an estimate hangs together with no other.
fn stands_alone(covariance: &DMatrix<f64>, i: usize) -> bool {
    let correlation = |j: usize| covariance[(i, j)] / (covariance[(i, i)] * covariance[(j, j)]).sqrt();
    (0..covariance.nrows()).all(|j| j == i || correlation(j).abs() < ROUND_OFF)
}

/// Makes the estimates at a minimum, with warnings.
pub fn estimates(
    objective: &Objective,
    solution: &Solution,
    covariance: &DMatrix<f64>,
    intervals: Vec<(Interval, Vec<(f64, f64)>)>,
    together: &[(usize, usize, Combination)],
) -> Vec<Estimate> {
    let estimate = |(i, (found, walked)): (usize, (Interval, Vec<(f64, f64)>))| {
        let (variable, parameter) = (&objective.variables[i], &objective.parameters[i]);
        let position = solution.position[i];
        let own = objective.data.model.effect_parameter(&parameter.path);
        let turn = own.or_else(|| objective.catalogue(i)).map_or(0.0, |entry| entry.turn(variable.value(position)));
        let value = variable.value(position) + turn;
        let interval = Interval { low: found.low.map(|v| v + turn), high: found.high.map(|v| v + turn) };
        let curvature = covariance[(i, i)].sqrt();
        let (low, high) = variable.within_reach(position);
        let std = if variable.steps.is_some() {
            // There is no curvature, and a place that is certain has no uncertainty.
            interval.std().unwrap_or(f64::INFINITY)
        } else if curvature < high - low {
            spread(curvature * variable.rate(position), &interval)
        } else {
            f64::INFINITY
        };
        let mut warnings = Vec::new();
        let is_open = interval.is_open();
        let is_idle = variable.prior.is_none() && is_open && is_idle(objective, solution, i);
        // Where nothing depends on it, it stands wherever the search happened to leave it.
        let at_bound = !is_idle && variable.is_at_bound(position);
        if at_bound {
            warnings.push("stands at its bound".to_string());
        }
        if is_open && !is_idle {
            warnings.push("the data leave its interval open".into());
        }
        let is_told_together = together.iter().any(|(a, b, _)| *a == i || *b == i);
        match variable.prior {
            Some((written, prior)) if (value - written).abs() > CONFLICTING * prior => {
                let times = (value - written).abs() / prior;
                warnings.push(format!("{times:.0} of its standard uncertainties from what is written"));
            }
            Some((_, prior)) if std >= prior * (1.0 - ROUND_OFF) && stands_alone(covariance, i) => {
                warnings.push("no row depends on it: a column states it, or nothing measured hangs on it".into());
            }
            None if is_idle => {
                warnings.push("no row depends on it, whatever its value: give it one, or take it away".into());
            }
            Some((_, prior)) if std > UNSHARPENED * prior => {
                warnings.push("the data hardly add to what was known".into());
            }
            None if !at_bound && is_open && !is_told_together && covariance[(i, i)].sqrt() * UNSEEN > variable.unit => {
                warnings.push("the data cannot see it".into());
            }
            _ => {}
        }
        if let Some(entry) = objective.catalogue(i)
            && !at_bound
            && !entry.is_plausible(value)
        {
            let (low, high) = entry.range;
            warnings.push(format!("outside what is plausible, {low} to {high} {}", entry.kind.unit));
        }
        let mut profile: Vec<(f64, f64)> = walked.into_iter().map(|(v, rise)| (v + turn, rise)).collect();
        profile.push((value, 0.0));
        profile.sort_by(|a, b| a.0.total_cmp(&b.0));
        Estimate { parameter: parameter.clone(), value, std, interval, warnings, profile }
    };
    intervals.into_iter().enumerate().map(estimate).collect()
}

/// Standard uncertainty from the curvature of χ², or from the width of the interval where the two contradict
/// each other: the curvature at the bottom of a valley that is no parabola does not tell its width.
fn spread(curvature: f64, interval: &Interval) -> f64 {
    match interval.std() {
        Some(width) if !(0.5..2.0).contains(&(curvature / width)) => width,
        _ => curvature,
    }
}
