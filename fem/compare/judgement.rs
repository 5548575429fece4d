//! Whether rows can tell that a model is right, or that it is wrong: the one rule of all commands.

use crate::measure::{LEAST_NEIGHBOURS, Measurements, Repeats};
use crate::noise::{Noise, NoiseSource, is_round_off};

/// Fewest places at which rows show that a model is wrong where nothing tells the noise: fewer rows have no structure that
/// chance has not.
const FEWEST_PLACES: usize = 6;

/// What rows can tell where their noise is known in this way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Judges {
    /// Nothing: they are too few, or stand too much alike.
    Nothing,
    /// That a model is wrong: too few neighbours tell how large the noise is for them to tell that it is right.
    Wrong,
    /// Both.
    Both,
}

impl Judges {
    /// What rows can tell of a model that leaves these residuals (SI), under a noise.
    pub fn of(data: &Measurements, residuals: &[f64], noise: &Noise, repeats: &Repeats) -> Self {
        // Rows that the model itself made need no noise to be held against.
        let is_exact = || is_round_off(residuals, &data.observed);
        match (noise.source, repeats.groups) {
            (NoiseSource::Column | NoiseSource::Covariance | NoiseSource::Repeats, _) => Self::Both,
            (NoiseSource::Estimated, places) if places < FEWEST_PLACES => Self::Nothing,
            (NoiseSource::Estimated, places) if places < LEAST_NEIGHBOURS && !is_exact() => Self::Wrong,
            (NoiseSource::Estimated, _) => Self::Both,
        }
    }

    /// A verdict, where they can tell it.
    pub fn verdict(self, is_right: bool) -> Option<bool> {
        let is_told = match self {
            Self::Nothing => false,
            Self::Wrong => !is_right,
            Self::Both => true,
        };
        is_told.then_some(is_right)
    }
}
