//! Screens all pairs of effects: the gain of each pair, to first order, with the best variants of both.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::gain::Gain;
use super::screening::{ScreenedVariant, Screening};
use super::sensitivity::CandidateEffect;

/// Two candidate effects in the variants with the largest joint gain.
#[derive(Clone, Debug)]
pub struct Pair {
    /// Variant of the effect with the lower number, and that of the other.
    variants: [usize; 2],
    /// Joint gain, with the amplitudes of both in the same order.
    gain: Gain,
}

impl Pair {
    /// Fall of χ² to first order.
    pub fn delta_chi2(&self) -> f64 {
        self.gain.delta_chi2
    }

    /// Variant and amplitudes of the effect with the lower number (0) or the higher (1).
    pub fn of(&self, candidates: [&CandidateEffect; 2], which: usize) -> (usize, &[f64]) {
        let (first, second) = self.gain.amplitudes.split_at(candidates[0].variants[self.variants[0]].linear.len());
        (self.variants[which], [first, second][which])
    }
}

/// Finds the joint gain of every pair of candidate effects that has any, by their numbers in rising order.
pub fn pairs(screening: &Screening) -> BTreeMap<(usize, usize), Pair> {
    let of_effects: Vec<&[ScreenedVariant]> = screening.variants.chunk_by(|a, b| a.candidate == b.candidate).collect();
    let pairs: Vec<(usize, usize)> = (0..of_effects.len()).flat_map(|j| (0..j).map(move |i| (i, j))).collect();
    let best = |(i, j): (usize, usize)| {
        let both = of_effects[i].iter().flat_map(|one| {
            let with = move |other: &ScreenedVariant| Pair {
                variants: [one.variant, other.variant],
                gain: screening.gain_of_pair(one, other),
            };
            of_effects[j].iter().map(with)
        });
        let best = both.filter(|p| p.delta_chi2() > 0.0).max_by(|p, q| p.delta_chi2().total_cmp(&q.delta_chi2()))?;
        Some(((of_effects[i][0].candidate, of_effects[j][0].candidate), best))
    };
    pairs.into_par_iter().filter_map(best).collect()
}
