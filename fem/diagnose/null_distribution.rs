//! Null distribution of the maximum statistic: the size of the best of all gains by chance alone
//! (look-elsewhere effect).
//!
//! Many effects with many nonlinear parameters are tried, and the best is taken; its Δχ² follows no χ²
//! distribution of a table. So the whole search is simulated on noise, with the same projection and the same
//! sensitivities, and the gain that was found is compared with those (parametric bootstrap).

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::gain::gain;
use super::residual_projection::ProjectedResidual;
use super::sensitivity::CandidateEffect;
use crate::compare::Rng;
use crate::measure::Repeats;
use crate::noise::{Acts, Noise, NoiseSource, beyond_chi2};

/// Number of simulated searches.
const SEARCHES: usize = 1000;
/// Number of exceedances below which a p-value is extrapolated along the tail of χ².
const FEW: usize = 10;

/// Source of the variance by which a gain is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Variance {
    /// σ is known.
    Known,
    /// σ² is estimated with these degrees of freedom.
    Estimated(f64),
    /// σ² comes from the residuals.
    Residual,
}

/// Simulated null distribution of the largest gain, in rising order.
#[derive(Clone)]
pub struct MaxStatistic {
    gains: Vec<f64>,
}

impl MaxStatistic {
    /// Simulates searches over `candidates`.
    pub fn simulate(projected: &ProjectedResidual, candidates: &[&CandidateEffect], variance: Variance) -> Self {
        let variants: Vec<ProjectedVariant> = candidates
            .iter()
            .flat_map(|c| &c.variants)
            .map(|v| {
                let columns = projected.project_columns(&v.columns);
                ProjectedVariant { gram: columns.transpose() * &columns, columns, signed: &v.signed }
            })
            .filter(|p| p.gram.diagonal().min() > 0.0)
            .collect();
        let search = |seed: usize| {
            let mut rng = Rng::new(seed as u64);
            let noise = DVector::from_fn(projected.residual.len(), |_, _| rng.normal());
            let best = variants.iter().map(|p| p.delta_chi2(&noise)).fold(0.0, f64::max);
            best / variance.square(projected, &noise, best, &mut rng)
        };
        let mut gains: Vec<f64> = (0..SEARCHES).into_par_iter().map(search).collect();
        gains.sort_unstable_by(f64::total_cmp);
        Self { gains }
    }

    /// Probability that chance alone gives as large a gain anywhere (global p-value).
    pub fn p_value(&self, gain: f64) -> f64 {
        let above = self.gains.len() - self.gains.partition_point(|g| *g < gain);
        if above >= FEW {
            return (above + 1) as f64 / (self.gains.len() + 1) as f64;
        }
        // Beyond the simulated gains the tail falls like that of χ² with one degree of freedom, times the
        // number of looks.
        let tail = |gain: f64| beyond_chi2(1.0, gain).unwrap_or(1.0);
        let known = self.gains[self.gains.len() - FEW];
        let looks = FEW as f64 / self.gains.len() as f64 / tail(known).max(f64::MIN_POSITIVE);
        (looks * tail(gain)).min(FEW as f64 / self.gains.len() as f64)
    }

    /// Gain that chance alone exceeds with this probability.
    pub fn quantile(&self, p: f64) -> f64 {
        let i = ((1.0 - p) * self.gains.len() as f64) as usize;
        self.gains[i.min(self.gains.len() - 1)]
    }
}

struct ProjectedVariant<'a> {
    columns: DMatrix<f64>,
    gram: DMatrix<f64>,
    signed: &'a [bool],
}

impl ProjectedVariant<'_> {
    /// Fall of χ² on a draw of noise. The columns are projected, so that the noise need not be.
    fn delta_chi2(&self, noise: &DVector<f64>) -> f64 {
        if let [signed] = self.signed {
            let along = self.columns.column(0).dot(noise);
            return if along > 0.0 || *signed { along * along / self.gram[(0, 0)] } else { 0.0 };
        }
        gain(&self.gram, &(self.columns.transpose() * noise), self.signed).delta_chi2
    }
}

impl Variance {
    /// Draws the estimate of σ² that data would give when its true value is 1.
    fn square(self, projected: &ProjectedResidual, noise: &DVector<f64>, gain: f64, rng: &mut Rng) -> f64 {
        match self {
            Self::Known => 1.0,
            // Wilson and Hilferty 1931: χ²_ν/ν is nearly the cube of a normal; to 1 % for ν ≥ 5.
            Self::Estimated(freedom) => {
                let a = 2.0 / (9.0 * freedom);
                (1.0 - a + rng.normal() * a.sqrt()).max(0.0).powi(3).max(1e-3)
            }
            Self::Residual => {
                let left = projected.project(noise.clone()).norm_squared() - gain;
                left / (projected.freedom - 1.0).max(1.0)
            }
        }
    }

    /// Gain on the scale of [`MaxStatistic`], where `left` is χ² with the effect and `freedom` its degrees
    /// of freedom.
    pub fn statistic(self, gain: f64, left: f64, freedom: f64) -> f64 {
        match self {
            Self::Known | Self::Estimated(_) => gain,
            Self::Residual => gain / (left / freedom.max(1.0)),
        }
    }
}

/// What the variance of the rows is known from.
pub fn variance(noise: &Noise, repeats: &Repeats) -> Variance {
    match noise.source {
        NoiseSource::Column | NoiseSource::Covariance => {
            of_smooth_sums(noise).map_or(Variance::Known, Variance::Estimated)
        }
        NoiseSource::Repeats => Variance::Estimated(repeats.effective_freedom()),
        NoiseSource::Estimated => Variance::Residual,
    }
}

/// Degrees of freedom of the variance of smooth sums over rows that share noise with coefficient ρ; `None` where they
/// do not.
///
/// That variance is proportional to (1 + ρ)/(1 − ρ), and ρ is estimated from n rows with variance (1 − ρ²)/n (Box,
/// Jenkins and Reinsel 1994, section 7.2): its relative variance is 4/(n·(1 − ρ²)), which is 2/ν (Satterthwaite 1946).
fn of_smooth_sums(noise: &Noise) -> Option<f64> {
    let term = noise.terms.iter().find(|t| matches!(t.effect.acts, Acts::Neighbours))?;
    let coefficient = (-1.0 / term.size).exp();
    Some(0.5 * noise.sigma.len() as f64 * (1.0 - coefficient * coefficient))
}
