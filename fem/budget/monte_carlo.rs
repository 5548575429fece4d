//! Monte Carlo of a budget: draws every error and every input from its law, sample by sample, and evaluates
//! the laws and the model themselves.

use std::sync::atomic::{AtomicU64, Ordering};

use rayon::prelude::*;

use super::{Budget, Contribution, Kind, Models, Stream};
use crate::process::Failure;
use crate::progress::Progress;

/// Estimate from samples, with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Value of the estimate.
    pub value: f64,
    /// Standard error: the change by another seed.
    pub error: f64,
}

/// Part of the production beyond the tolerance, 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rejects {
    /// Part of the samples.
    pub drawn: Measured,
    /// Part of a normal distribution of the same mean and standard deviation.
    pub normal: f64,
}

/// Result of the samples. m.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// Number of samples.
    pub samples: usize,
    /// Mean of the total.
    pub mean: Measured,
    /// Standard deviation of the total.
    pub std: Measured,
    /// Ends of the interval outside which the risk lies, half of it on either side.
    pub interval: [Measured; 2],
    /// Absolute value of the end that lies further from zero.
    pub extent: f64,
    /// Part beyond the tolerance, if there is one.
    pub rejects: Option<Rejects>,
    /// Number of draws that fell where there is no model and were repeated.
    pub redrawn: u64,
}

/// Draws the samples of a budget, its errors with the given signs, and those of the figures of its models.
///
/// # Errors
/// A model cannot be computed at a draw.
pub(super) fn draw(
    budget: &Budget,
    errors: &[Contribution],
    signs: &[f64],
    progress: &Progress,
) -> Result<Drawn, Failure> {
    progress.expect(budget.samples as u64);
    let redrawn = AtomicU64::new(0);
    let sample = |i: usize| {
        let result = one(budget, (errors, signs), &Stream::new(budget.seed, i as u64), &redrawn);
        progress.advance(1);
        result
    };
    let mut results: Vec<f64> =
        (0..budget.samples).into_par_iter().with_min_len(64).map(sample).collect::<Result<_, Failure>>()?;
    // Sums run in the order of the samples, so that the number of threads changes no digit.
    let count = results.len() as f64;
    let mean = results.iter().sum::<f64>() / count;
    let moment = |power: i32| results.iter().map(|r| (r - mean).powi(power)).sum::<f64>() / count;
    let variance = moment(2) * count / (count - 1.0);
    let std = variance.sqrt();
    // The variance of a sample's variance is (μ₄ − σ⁴)/N.
    let std_error = ((moment(4) - variance * variance).max(0.0) / count).sqrt() / (2.0 * std).max(f64::MIN_POSITIVE);
    let rejects = budget.tolerance.map(|(lower, upper)| {
        let part = results.iter().filter(|r| **r < lower || **r > upper).count() as f64 / count;
        Rejects {
            drawn: Measured { value: part, error: (part * (1.0 - part) / count).sqrt() },
            normal: beyond(mean, std, lower, upper),
        }
    });
    results.sort_unstable_by(f64::total_cmp);
    let risk = budget.risk();
    let interval = [0.5 * risk, 1.0 - 0.5 * risk].map(|p| quantile(&results, p));
    Ok(Drawn {
        samples: results.len(),
        mean: Measured { value: mean, error: std / count.sqrt() },
        std: Measured { value: std, error: std_error },
        interval,
        extent: interval[0].value.abs().max(interval[1].value.abs()),
        rejects,
        redrawn: redrawn.into_inner(),
    })
}

/// Total on one part, m.
fn one(
    budget: &Budget,
    (errors, signs): (&[Contribution], &[f64]),
    stream: &Stream,
    redrawn: &AtomicU64,
) -> Result<f64, Failure> {
    let (mut total, mut dimension) = (0.0, 0);
    for error in errors {
        total += error.draw(stream, dimension);
        dimension += error.dimensions();
    }
    let Models { parts, inputs } = &budget.models;
    let mut values = Vec::with_capacity(inputs.len());
    for input in inputs {
        let Some((value, again)) = input.draw(stream, dimension) else {
            return Err(Failure {
                message: format!("hardly any draw of {} is a possible value", input.name),
                help: "narrow its field, or move its middle".into(),
            });
        };
        redrawn.fetch_add(u64::from(again), Ordering::Relaxed);
        values.push(value);
        dimension += 1;
    }
    for ((part, figure), sign) in parts.iter().zip(budget.models.results(&values)?).zip(signs) {
        total += match part.kind {
            Kind::Systematic => sign * figure,
            Kind::Random => figure * part.law.draw(stream, dimension, 0),
        };
        dimension += 1;
    }
    Ok(total)
}

/// Quantile p of the sorted samples; its standard error from the samples one standard deviation of the
/// binomial distribution before and after it.
fn quantile(sorted: &[f64], p: f64) -> Measured {
    let count = sorted.len() as f64;
    let at = |part: f64| {
        let position = (part * count - 0.5).clamp(0.0, count - 1.0);
        let (below, share) = (position.floor() as usize, position.fract());
        sorted[below] + share * (sorted[(below + 1).min(sorted.len() - 1)] - sorted[below])
    };
    let spread = (p * (1.0 - p) / count).sqrt();
    Measured { value: at(p), error: 0.5 * (at(p + spread) - at(p - spread)) }
}

/// Part of a normal distribution outside a tolerance.
fn beyond(mean: f64, std: f64, lower: f64, upper: f64) -> f64 {
    if std == 0.0 {
        return f64::from(u8::from(mean < lower || mean > upper));
    }
    let tail = |distance: f64| 0.5 * statrs::function::erf::erfc(distance / std / std::f64::consts::SQRT_2);
    tail(mean - lower) + tail(upper - mean)
}
