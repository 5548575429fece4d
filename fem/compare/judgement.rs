//! Whether rows can tell that a model is right, or that it is wrong: the one rule of all commands.

use crate::measure::{LEAST_FREEDOM, LEAST_NEIGHBOURS, Measurements, Repeats};
use crate::noise::{Acts, Noise, NoiseSource, is_round_off};

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

/// Whether rows that repeat each other tell a noise that neighbours share, so that it is no pure error any more.
fn is_of_repeats(noise: &Noise, repeats: &Repeats) -> bool {
    let is_shared = noise.terms.iter().any(|term| matches!(term.effect.acts, Acts::Neighbours));
    is_shared && repeats.scatter.iter().all(|own| own.freedom >= LEAST_FREEDOM && own.sum_of_squares > 0.0)
}

impl Judges {
    /// What rows can tell of a model that leaves these residuals (SI), under a noise.
    pub fn of(data: &Measurements, residuals: &[f64], noise: &Noise, repeats: &Repeats) -> Self {
        // Rows that the model itself made need no noise to be held against.
        let is_exact = || is_round_off(residuals, &data.observed);
        match (noise.source, repeats.groups) {
            _ if data.are_all_alike() => Self::Nothing,
            (NoiseSource::Column | NoiseSource::Covariance | NoiseSource::Repeats, _) => Self::Both,
            _ if is_of_repeats(noise, repeats) => Self::Both,
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
