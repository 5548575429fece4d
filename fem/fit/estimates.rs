//! The fitted parameters as the user sees them, with warnings.

use nalgebra::DMatrix;

use super::Estimate;
use super::intervals::Interval;
use super::objective::{Objective, Solution};

/// A parameter moves the prediction so little that the data cannot see it: less than this many standard deviations, all rows
/// together, over the whole of its usual size.
const UNSEEN: f64 = 0.3;
/// A value so many of its own standard uncertainties from what was written contradicts that.
const CONTRADICTED: f64 = 4.0;
/// A prior is hardly sharpened by the data when its uncertainty stays above this part.
const UNSHARPENED: f64 = 0.95;

/// The parameters as the user sees them, with warnings.
pub fn estimates(
    objective: &Objective,
    solution: &Solution,
    covariance: &DMatrix<f64>,
    intervals: Vec<Interval>,
) -> Vec<Estimate> {
    let estimate = |(i, found): (usize, Interval)| {
        let (axis, parameter) = (&objective.axes[i], &objective.parameters[i]);
        let position = solution.position[i];
        let turn = objective.catalogue(i).map_or(0.0, |entry| entry.turn(axis.value(position)));
        let value = axis.value(position) + turn;
        let interval = Interval { low: found.low.map(|v| v + turn), high: found.high.map(|v| v + turn) };
        let curvature = covariance[(i, i)].sqrt();
        let (low, high) = axis.within_reach(position);
        let std =
            if curvature < high - low { spread(curvature * axis.rate(position), &interval) } else { f64::INFINITY };
        let mut warnings = Vec::new();
        let at_bound = position <= axis.low || position >= axis.high;
        if at_bound {
            warnings.push("stands at its bound".to_string());
        }
        if interval.low.is_none() || interval.high.is_none() {
            warnings.push("the data leave its interval open".into());
        }
        match axis.prior {
            Some((written, prior)) if (value - written).abs() > CONTRADICTED * prior => {
                let times = (value - written).abs() / prior;
                warnings.push(format!("{times:.0} of its standard uncertainties from what is written"));
            }
            Some((_, prior)) if std > UNSHARPENED * prior => {
                warnings.push("the data hardly add to what was known".into());
            }
            None if !at_bound
                && (interval.low.is_none() || interval.high.is_none())
                && covariance[(i, i)].sqrt() * UNSEEN > axis.unit =>
            {
                warnings.push("the data cannot see it".into());
            }
            _ => {}
        }
        if let Some(entry) = objective.catalogue(i) {
            let shown = entry.kind.from_si(value);
            if !at_bound && !(entry.range.0..=entry.range.1).contains(&shown) {
                warnings.push(format!(
                    "outside what is plausible, {} to {} {}",
                    entry.range.0, entry.range.1, entry.kind.unit
                ));
            }
        }
        Estimate { parameter: parameter.clone(), value, std, interval, warnings }
    };
    intervals.into_iter().enumerate().map(estimate).collect()
}

/// The standard uncertainty from the curvature, or from the width of the interval where the two contradict each other: the curvature at the
/// bottom of a valley that is no parabola says nothing of its width.
fn spread(curvature: f64, interval: &Interval) -> f64 {
    /// Half the width of a 95 % interval of a normal.
    const HALF: f64 = 1.959_964;
    let width = interval.low.zip(interval.high).map(|(low, high)| 0.5 * (high - low) / HALF);
    match width {
        Some(width) if !(0.5..2.0).contains(&(curvature / width)) => width,
        _ => curvature,
    }
}
