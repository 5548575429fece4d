//! The price of looking everywhere: how large the best of all gains becomes by chance alone.
//!
//! Many effects with many shapes are tried, and the best is taken; its gain is no χ² of a table. So the whole search is run on noise,
//! on the same ground and with the same signatures, and the gain that was found is held against those.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;
use statrs::distribution::{ChiSquared, ContinuousCDF};

use super::gain::gain;
use super::ground::Ground;
use super::signature::Candidate;
use crate::compare::Chance;

/// Searches on noise.
const SEARCHES: usize = 1000;
/// Below this many exceedances a p-value is carried on along the tail of χ².
const FEW: usize = 10;

/// How the noise is known, which decides what a gain is measured by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Yardstick {
    /// σ is known.
    Known,
    /// σ² comes from repeats with these degrees of freedom.
    Repeats(f64),
    /// σ² comes from what is left.
    LeftOver,
}

/// Gains of the best effect on noise alone, rising.
#[derive(Clone)]
pub struct Price {
    gains: Vec<f64>,
}

impl Price {
    /// Of a search over `candidates` on a ground.
    pub fn simulate(ground: &Ground, candidates: &[&Candidate], yardstick: Yardstick) -> Self {
        let projected: Vec<Projected> = candidates
            .iter()
            .flat_map(|c| &c.variants)
            .map(|v| {
                let columns = ground.project_columns(&v.columns);
                Projected { gram: columns.transpose() * &columns, columns, signed: &v.signed }
            })
            .filter(|p| p.gram.diagonal().min() > 0.0)
            .collect();
        let search = |seed: usize| {
            let mut chance = Chance::new(seed as u64);
            let noise = DVector::from_fn(ground.residual.len(), |_, _| chance.normal());
            let best = projected.iter().map(|p| p.fall(&noise)).fold(0.0, f64::max);
            best / yardstick.square(ground, &noise, best, &mut chance)
        };
        let mut gains: Vec<f64> = (0..SEARCHES).into_par_iter().map(search).collect();
        gains.sort_unstable_by(f64::total_cmp);
        Self { gains }
    }

    /// How often chance alone gives as large a gain anywhere.
    pub fn p_value(&self, gain: f64) -> f64 {
        let above = self.gains.len() - self.gains.partition_point(|g| *g < gain);
        if above >= FEW {
            return (above + 1) as f64 / (self.gains.len() + 1) as f64;
        }
        // Beyond what was simulated the tail falls like that of χ² with one degree of freedom, times the number of looks.
        let Ok(tail) = ChiSquared::new(1.0) else { return 1.0 };
        let known = self.gains[self.gains.len() - FEW];
        let looks = FEW as f64 / self.gains.len() as f64 / tail.sf(known).max(f64::MIN_POSITIVE);
        (looks * tail.sf(gain)).min(FEW as f64 / self.gains.len() as f64)
    }

    /// The gain that chance alone exceeds with this probability.
    pub fn quantile(&self, p: f64) -> f64 {
        let i = ((1.0 - p) * self.gains.len() as f64) as usize;
        self.gains[i.min(self.gains.len() - 1)]
    }
}

struct Projected<'a> {
    columns: DMatrix<f64>,
    gram: DMatrix<f64>,
    signed: &'a [bool],
}

impl Projected<'_> {
    /// The columns are projected, so that the noise need not be.
    fn fall(&self, noise: &DVector<f64>) -> f64 {
        if let [signed] = self.signed {
            let along = self.columns.column(0).dot(noise);
            return if along > 0.0 || *signed { along * along / self.gram[(0, 0)] } else { 0.0 };
        }
        gain(&self.gram, &(self.columns.transpose() * noise), self.signed).fall
    }
}

impl Yardstick {
    /// σ² as the data would give it, when its true value is 1.
    fn square(self, ground: &Ground, noise: &DVector<f64>, gain: f64, chance: &mut Chance) -> f64 {
        match self {
            Self::Known => 1.0,
            // Wilson and Hilferty 1931: χ²_ν/ν is nearly the cube of a normal; to 1 % for ν ≥ 5.
            Self::Repeats(freedom) => {
                let a = 2.0 / (9.0 * freedom);
                (1.0 - a + chance.normal() * a.sqrt()).max(0.0).powi(3).max(1e-3)
            }
            Self::LeftOver => {
                let left = ground.project(noise.clone()).norm_squared() - gain;
                left / (ground.freedom - 1.0).max(1.0)
            }
        }
    }

    /// A gain as [`Price`] measures it, when `left` is χ² with the effect and `freedom` its degrees of freedom.
    pub fn measure(self, gain: f64, left: f64, freedom: f64) -> f64 {
        match self {
            Self::Known | Self::Repeats(_) => gain,
            Self::LeftOver => gain / (left / freedom.max(1.0)),
        }
    }
}
