//! Compares a model with measurements: the size of the residuals, their goodness of fit, and their
//! structure.

mod binning;
mod features;
mod judgement;
mod rng;
mod sentence;
mod significance;
mod trend;
mod waves;

pub use binning::Along;
pub use features::{Feature, find as features};
pub use judgement::Judges;
pub use rng::Rng;
pub use significance::SIGNIFICANCE;
pub use trend::Trend;

use std::ops::Range;

use nalgebra::DMatrix;

use crate::measure::{MeasuredObservable, Measurements, Repeats, Scatter};
use crate::model::{Data, Model};
use crate::noise::{Noise, NoiseSource, Term, beyond_chi2, beyond_f, suspects};
use crate::process::Failure;

/// Comparison of one model with one file of measurements. SI units.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Comparison {
    /// File of the model.
    pub model: String,
    /// Prediction of every row.
    pub predicted: Vec<f64>,
    /// Measured − predicted.
    pub residuals: Vec<f64>,
    /// Noise by which the residuals are judged.
    #[doc(hidden)]
    pub noise: Noise,
    /// Root mean square of the errors: the residuals of all rows on one scale, SI, or standard uncertainties where
    /// the file has several observables.
    pub rms: f64,
    /// Mean of the errors.
    pub bias: f64,
    /// Row of the largest |error|, from 0.
    pub worst: usize,
    /// The error of that row.
    pub worst_error: f64,
    /// Reduced χ² against a known noise, or lack of fit over pure error (F) with repeats; no number where nothing scatters.
    pub reduced_chi2: f64,
    /// Probability that chance alone gives a larger χ² (p-value); `None` where the noise is only estimated.
    pub p_value: Option<f64>,
    /// What these rows can tell of a model.
    #[doc(hidden)]
    pub judges: Judges,
    /// Structure of the residuals, the largest share first.
    #[doc(hidden)]
    pub features: Vec<Feature>,
    /// Effects of the measurement that the residuals ask for though the noise seems to explain them: repeats
    /// that differ from run to run are no noise.
    #[doc(hidden)]
    pub suspects: Vec<Term>,
    /// Cautions about the effects of the measurement that the model states, and about what its prediction asks of the
    /// machine.
    pub cautions: Vec<String>,
}

impl Comparison {
    /// Whether the noise explains what the model leaves; `None` where the rows are too few, or too much alike, to tell.
    pub fn adequacy(&self) -> Option<bool> {
        let is_explained = self.p_value.is_none_or(|p| p >= SIGNIFICANCE) && self.features.is_empty();
        self.judges.verdict(is_explained && self.suspects.is_empty() && !self.is_rougher())
    }

    /// Whether the noise surely explains it: where the rows cannot tell it does not.
    pub fn adequate(&self) -> bool {
        self.adequacy() == Some(true)
    }

    /// Whether the residuals are far larger than the scatter of neighbouring rows, where the noise is
    /// estimated from that scatter alone: the model fails though along no coordinate.
    pub fn is_rougher(&self) -> bool {
        const ROUGHER: f64 = 25.0;
        self.noise.source == NoiseSource::Estimated && self.reduced_chi2 > ROUGHER
    }
}

/// Agreement of one of several observables. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Root mean square of its residuals, SI.
    pub rms: f64,
    /// Root mean square of its noise, SI.
    pub sigma: f64,
}

impl Comparison {
    /// Agreement of one of the file's observables.
    #[doc(hidden)]
    pub fn agreement(&self, measurements: &Measurements, seen: &MeasuredObservable) -> Agreement {
        let rows = || (0..measurements.len()).filter(|row| measurements.rows.observable[*row] == seen.position);
        Agreement {
            rms: root_mean_square(rows().map(|row| self.residuals[row])),
            sigma: root_mean_square(rows().map(|row| self.noise.sigma[row])),
        }
    }
}

/// Compares the model as it is written.
///
/// # Errors
/// The model could not be computed.
pub fn compare(data: &Data) -> Result<Comparison, Failure> {
    let forward = data.model.forward();
    let mut comparison = judged(data, &data.terms, forward.observe(&data.rows)?);
    comparison.cautions.extend(forward.doubts(&data.rows)?);
    Ok(comparison)
}

/// Judges a prediction of every row, with the effects of the measurement that are at work in it.
pub fn judged(data: &Data, terms: &[Term], predicted: Vec<f64>) -> Comparison {
    let (model, measurements): (&Model, &Measurements) = (data.model, data);
    let residuals = measurements.residuals(&predicted);
    let nothing = DMatrix::zeros(measurements.len(), 0);
    let (noise, repeats) = Noise::stated(terms, measurements, data.repeats(), &residuals, &nothing);
    let evidence = data.evidence(&noise, data.repeats(), &residuals, &nothing);
    let errors = measurements.together(&residuals, &noise.sigma);
    let worst = (0..errors.len()).max_by(|a, b| errors[*a].abs().total_cmp(&errors[*b].abs())).unwrap_or(0);
    let blind = data.datum_directions.len() as f64;
    let (reduced_chi2, p_value) = reduced_chi2(measurements, (&residuals, &noise), &repeats, (blind, 0.0));
    let features = features::find(&*model.process, measurements, &residuals, &noise);
    let is_explained = p_value.is_none_or(|p| p >= SIGNIFICANCE) && features.is_empty();
    let suspects = if is_explained { suspects(&evidence) } else { Vec::new() };
    Comparison {
        model: model.source.name.to_string(),
        rms: rms(&errors),
        bias: errors.iter().sum::<f64>() / errors.len() as f64,
        worst_error: errors.get(worst).copied().unwrap_or(f64::NAN),
        worst,
        reduced_chi2,
        p_value,
        judges: Judges::of(measurements, &residuals, &noise, &repeats),
        features,
        suspects,
        cautions: data.cautions.iter().cloned().chain(caution(measurements, &noise, reduced_chi2)).collect(),
        predicted,
        residuals,
        noise,
    }
}

/// Caution about what a reduced χ² is of, to be read before it is believed: readings that are no measurement, or uncertainties
/// that cannot be meant.
pub fn caution(measurements: &Measurements, noise: &Noise, reduced_chi2: f64) -> Option<String> {
    /// Standard uncertainties that a model is off by, or their part, in which nothing is stated any more: a hundred thousand, a
    /// thousandth.
    const NOT_TO_BE_MEANT: Range<f64> = 1e-3..1e5;
    let times = reduced_chi2.sqrt();
    if measurements.are_all_alike() {
        let alike = "all readings are one number: nothing was measured, or the gauge is too coarse to see what the rows differ in";
        return Some(alike.into());
    }
    (noise.source.is_known() && times > 0.0 && !NOT_TO_BE_MEANT.contains(&times)).then(|| {
        format!("the rows are off by {times:.0e} times their standard uncertainties: are those meant, and in the right unit?")
    })
}

/// Root mean square.
pub fn rms(values: &[f64]) -> f64 {
    root_mean_square(values.iter().copied())
}

fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0), |(sum, count), value| (sum + value * value, count + 1));
    (sum / f64::from(count)).sqrt()
}

/// Reduced χ² of residuals (SI) and its p-value for a known noise; for repeats lack of fit over pure error, by the F
/// distribution, which is no number where no conditions are left to lack anything; no p-value where the noise is only
/// estimated, and no number where that is round-off. `taken` degrees of freedom were taken out of the residuals, and `known`
/// is what prior knowledge adds to χ².
pub fn reduced_chi2(
    data: &Measurements,
    (residuals, noise): (&[f64], &Noise),
    repeats: &Repeats,
    (taken, known): (f64, f64),
) -> (f64, Option<f64>) {
    let z = noise.whiten(residuals.iter().copied());
    let chi2 = known + z.iter().map(|z| z * z).sum::<f64>();
    let n = (residuals.len() as f64 - taken - noise.free_directions() as f64).max(1.0);
    match noise.source {
        NoiseSource::Column | NoiseSource::Covariance => (chi2 / n, beyond_chi2(n, chi2)),
        NoiseSource::Repeats => {
            let (mut sum, mut count) = (vec![0.0; repeats.groups], vec![0.0; repeats.groups]);
            for (g, z) in repeats.group.iter().zip(&z) {
                sum[g] += z;
                count[g] += 1.0;
            }
            let lack = known + sum.iter().zip(&count).map(|(s, n)| s * s / n).sum::<f64>();
            let freedom = repeats.groups as f64 - taken - noise.free_between(&repeats.groups_of_rows());
            if freedom < 1.0 {
                return (f64::NAN, None);
            }
            let f = lack / freedom / pure_error(data, noise, repeats);
            (f, beyond_f(freedom, repeats.effective_freedom(), f))
        }
        NoiseSource::Estimated if noise.is_round_off(data) => (f64::NAN, None),
        NoiseSource::Estimated => (chi2 / n, None),
    }
}

/// Mean square by which rows differ from those that they repeat, in units of the noise, whose level may be another beside
/// effects of the measurement.
fn pure_error(data: &Measurements, noise: &Noise, repeats: &Repeats) -> f64 {
    let level = |number: usize| noise.usual(data, data.observables[number].position);
    let of_own = |(i, scatter): (usize, &Scatter)| scatter.sum_of_squares / level(i).powi(2);
    repeats.scatter.iter().enumerate().map(of_own).sum::<f64>() / repeats.freedom() as f64
}
