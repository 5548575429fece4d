//! Null distribution of the maximum statistic: the size of the best of all gains by chance alone
//! (look-elsewhere effect).
//!
//! Many effects with many nonlinear parameters are tried, and the best is taken; its Δχ² follows no χ²
//! distribution of a table. So the whole search is simulated on noise, with the same projection and the same
//! sensitivities, and the gain that was found is compared with those (parametric bootstrap). A search sees the rows
//! only through their products with the sensitivities, whose distribution is known: no row need be drawn.

use nalgebra::DMatrix;
use rayon::prelude::*;

use super::screening::Screening;
use crate::compare::Rng;
use crate::measure::Repeats;
use crate::noise::{Acts, Noise, NoiseSource, beyond_chi2};

/// Number of simulated searches, and of those that are drawn together.
const SEARCHES: usize = 1000;
const TOGETHER: usize = 50;
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
    /// Simulates searches over candidates beside a residual with so many degrees of freedom.
    pub fn simulate(screening: &Screening, freedom: f64, variance: Variance) -> Self {
        let factor = screening.factor();
        let together = |first: usize| {
            let mut draws: Vec<Rng> = (first..first + TOGETHER).map(|seed| Rng::new(seed as u64)).collect();
            let mut normal = DMatrix::zeros(factor.ncols(), TOGETHER);
            for (mut column, rng) in normal.column_iter_mut().zip(&mut draws) {
                column.iter_mut().for_each(|entry| *entry = rng.normal());
            }
            let along = &factor * &normal;
            let gain = |(number, mut rng): (usize, Rng)| {
                let own = &along.as_slice()[number * along.nrows()..][..along.nrows()];
                let best = screening.variants.iter().map(|v| screening.delta_chi2(v, own)).fold(0.0, f64::max);
                let left = normal.column(number).norm_squared() - best;
                best / variance.square(left, factor.ncols() as f64, freedom, &mut rng)
            };
            draws.into_iter().enumerate().map(gain).collect::<Vec<f64>>()
        };
        let starts: Vec<usize> = (0..SEARCHES).step_by(TOGETHER).collect();
        let mut gains: Vec<f64> = starts.into_par_iter().flat_map_iter(together).collect();
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

impl Variance {
    /// Draws the estimate of σ² that data with so many degrees of `freedom` would give when its true value is 1; `left`
    /// is the χ² that the best effect leaves of the directions that effects can make, of which `inside` is the number.
    fn square(self, left: f64, inside: f64, freedom: f64, rng: &mut Rng) -> f64 {
        match self {
            Self::Known => 1.0,
            Self::Estimated(freedom) => (chi2(freedom, rng) / freedom).max(1e-3),
            Self::Residual => (left + chi2(freedom - inside, rng)) / (freedom - 1.0).max(1.0),
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

/// Draws χ² with ν degrees of freedom: nearly ν times the cube of a normal, to 1 % for ν ≥ 5 (Wilson and Hilferty
/// 1931); a sum of squares where a few are left.
fn chi2(freedom: f64, rng: &mut Rng) -> f64 {
    const FEW: f64 = 8.0;
    if freedom < FEW && freedom.fract() == 0.0 {
        return (0..freedom.max(0.0) as usize).map(|_| rng.normal().powi(2)).sum();
    }
    let a = 2.0 / (9.0 * freedom);
    freedom * (1.0 - a + rng.normal() * a.sqrt()).max(0.0).powi(3)
}

/// Knowledge of the variance of the rows, by the source of their noise.
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
