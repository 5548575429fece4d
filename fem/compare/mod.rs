//! A model against measurements: how large the difference is, whether the noise explains it, and where it has structure.

mod chance;
mod features;
mod noise;
mod shape;
mod waves;

pub use chance::Chance;
pub use features::{Axis, Feature, find as features};
pub use noise::{Level, Noise, NoiseSource};
pub use shape::Shape;

use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

use crate::measure::{Measurements, Repeats, Seen, repeats};
use crate::model::Model;
use crate::process::Failure;

/// A model is adequate when chance alone would give a larger misfit this often, and no structure stands out.
pub const SIGNIFICANCE: f64 = 0.01;

/// One model against one file of measurements. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The model's file.
    pub model: String,
    /// Prediction of every row.
    pub predicted: Vec<f64>,
    /// Measured − predicted.
    pub residuals: Vec<f64>,
    /// The noise they are judged by.
    pub noise: Noise,
    /// Residuals of all rows as they are told together: SI, or in standard uncertainties where the file has several observables.
    pub errors: Vec<f64>,
    /// Root mean square of the errors.
    pub rms: f64,
    /// Mean of the errors.
    pub bias: f64,
    /// Row of the largest |error|, from 0.
    pub worst: usize,
    /// χ²/ν against a known noise, or lack of fit over pure error.
    pub misfit: f64,
    /// How often chance alone gives a larger misfit; `None` where the noise is only estimated.
    pub p_value: Option<f64>,
    /// Where it fails, the largest share first.
    pub features: Vec<Feature>,
}

impl Comparison {
    /// Whether the noise explains what the model leaves.
    pub fn adequate(&self) -> bool {
        self.p_value.is_none_or(|p| p >= SIGNIFICANCE) && self.features.is_empty() && !self.is_rougher()
    }

    /// Whether far more is left than neighbouring rows scatter by, where the noise is known from nothing else: though it follows no coordinate.
    pub fn is_rougher(&self) -> bool {
        const ROUGHER: f64 = 25.0;
        self.noise.source == NoiseSource::Estimated && self.misfit > ROUGHER
    }
}

/// How well one of several observables agrees. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Root mean square of its residuals.
    pub rms: f64,
    /// Root mean square of its noise.
    pub sigma: f64,
}

impl Comparison {
    /// Of one of the file's observables.
    pub fn agreement(&self, measurements: &Measurements, seen: &Seen) -> Agreement {
        let rows = || (0..measurements.len()).filter(|row| measurements.rows.observable[*row] == seen.position);
        let of = |values: &[f64]| rms(&rows().map(|row| values[row]).collect::<Vec<_>>());
        Agreement { rms: of(&self.residuals), sigma: of(&self.noise.sigma) }
    }
}

/// Compares the model as it is written.
///
/// # Errors
/// The model could not be computed.
pub fn compare(model: &Model, measurements: &Measurements) -> Result<Comparison, Failure> {
    let measurements = &*measurements.seen_by(&*model.system);
    let predicted = model.job().observe(&measurements.rows)?;
    let residuals: Vec<f64> = measurements.observed.iter().zip(&predicted).map(|(y, p)| y - p).collect();
    let repeats = repeats(measurements, model.process.coordinates());
    let noise = Noise::of(measurements, &repeats, &residuals);
    let errors = measurements.together(&residuals, &noise.sigma);
    let worst = (0..errors.len()).max_by(|a, b| errors[*a].abs().total_cmp(&errors[*b].abs())).unwrap_or(0);
    let (misfit, p_value) = misfit(&residuals, &noise, &repeats, measurements.blind.len());
    Ok(Comparison {
        model: model.source.name.to_string(),
        rms: rms(&errors),
        bias: errors.iter().sum::<f64>() / errors.len() as f64,
        worst,
        misfit,
        p_value,
        features: features::find(model.process, measurements, &residuals, &noise),
        predicted,
        residuals,
        errors,
        noise,
    })
}

/// Root mean square.
pub fn rms(values: &[f64]) -> f64 {
    (values.iter().map(|v| v * v).sum::<f64>() / values.len() as f64).sqrt()
}

/// χ²/ν and its p-value for a known noise; for repeats the lack of fit over the pure error, by the F distribution. `blind` directions were
/// taken out of the residuals.
fn misfit(residuals: &[f64], noise: &Noise, repeats: &Repeats, blind: usize) -> (f64, Option<f64>) {
    let left = |count: usize| count.saturating_sub(blind).max(1) as f64;
    let n = left(residuals.len());
    let chi2: f64 = residuals.iter().zip(&noise.sigma).map(|(r, s)| (r / s).powi(2)).sum();
    match noise.source {
        NoiseSource::Column => (chi2 / n, ChiSquared::new(n).ok().map(|d| d.sf(chi2))),
        NoiseSource::Repeats => {
            let (mut sum, mut count) = (vec![0.0; repeats.groups], vec![0.0; repeats.groups]);
            for ((&g, r), s) in repeats.group.iter().zip(residuals).zip(&noise.sigma) {
                sum[g] += r / s;
                count[g] += 1.0;
            }
            let lack: f64 = sum.iter().zip(&count).map(|(s, n)| s * s / n).sum();
            let groups = left(repeats.groups);
            let f = lack / groups;
            (f, FisherSnedecor::new(groups, repeats.yardstick()).ok().map(|d| d.sf(f)))
        }
        NoiseSource::Estimated => (chi2 / n, None),
    }
}
