//! A random order of any length that needs no memory.

use crate::budget::Stream;

/// Rounds of the network; four suffice for a permutation that no test of order tells from a random one (Luby and
/// Rackoff 1988).
const ROUNDS: u32 = 6;

/// A permutation of 0, 1, …, `length` − 1: a balanced Feistel network over the next even power of two, walked on
/// from what lies beyond the length.
#[derive(Clone, Copy, Debug)]
pub struct Shuffle {
    length: u64,
    half_bits: u32,
    seed: u64,
    /// Number of the permutation among those of the seed.
    number: u32,
}

impl Shuffle {
    /// Permutation `number` of a seed, of so many.
    pub fn new(length: u64, seed: u64, number: u32) -> Self {
        let bits = u64::BITS - length.saturating_sub(1).leading_zeros();
        Self { length, half_bits: bits.div_ceil(2).max(1), seed, number }
    }

    /// Element at place `place`.
    pub fn at(&self, place: u64) -> u64 {
        let mut value = self.once(place);
        while value >= self.length {
            value = self.once(value);
        }
        value
    }

    fn once(&self, value: u64) -> u64 {
        let mask = (1 << self.half_bits) - 1;
        let (mut left, mut right) = (value >> self.half_bits, value & mask);
        for round in 0..ROUNDS {
            let [mixed, _] = Stream::new(self.seed, right).uniform(self.number, 1 + round);
            (left, right) = (right, left ^ (mixed * (mask + 1) as f64) as u64);
        }
        left << self.half_bits | right
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_stands_at_one_place() {
        for length in [1, 2, 3, 5, 64, 1000] {
            for number in 0..3 {
                let shuffle = Shuffle::new(length, 9, number);
                let mut all: Vec<u64> = (0..length).map(|i| shuffle.at(i)).collect();
                all.sort_unstable();
                assert!(all.into_iter().eq(0..length), "{length}");
            }
        }
    }

    #[test]
    fn two_orders_are_independent() {
        let (a, b) = (Shuffle::new(4096, 1, 0), Shuffle::new(4096, 1, 1));
        let product: f64 = (0..4096).map(|i| (a.at(i) as f64 - 2047.5) * (b.at(i) as f64 - 2047.5)).sum();
        // Correlation of independent permutations: zero, with a standard deviation of 1/sqrt(4095).
        let correlation = product / 4096.0 / ((4096.0f64.powi(2) - 1.0) / 12.0);
        assert!(correlation.abs() < 4.0 / 4095f64.sqrt(), "{correlation}");
    }
}
