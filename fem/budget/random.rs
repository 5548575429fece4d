//! Counter-based random numbers: they depend on nothing but the seed, the sample and the input, whatever the
//! number of threads.

/// Multipliers and Weyl increments of Philox4x32 (Salmon, Moraes, Dror and Shaw, "Parallel random numbers:
/// as easy as 1, 2, 3", SC 2011).
const MULTIPLIERS: [u32; 2] = [0xD251_1F53, 0xCD9E_8D57];
const WEYL: [u32; 2] = [0x9E37_79B9, 0xBB67_AE85];
const ROUNDS: usize = 10;

/// Random numbers of one sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stream {
    seed: u64,
    sample: u64,
}

impl Stream {
    /// Starts the numbers of sample `sample`.
    pub fn new(seed: u64, sample: u64) -> Self {
        Self { seed, sample }
    }

    /// Draws two independent numbers in (0, 1) for an input, others at each attempt.
    pub fn uniform(&self, dimension: u32, attempt: u32) -> [f64; 2] {
        let halves = |wide: u64| [wide as u32, (wide >> 32) as u32];
        let [low, high] = halves(self.sample);
        let [a, b, c, d] = philox([low, high, dimension, attempt], halves(self.seed));
        [[a, b], [c, d]].map(|[low, high]| {
            let bits = (u64::from(high) << 32 | u64::from(low)) >> 11;
            // 53 bits, and half a step so that neither end is met.
            (bits as f64 + 0.5) / 9_007_199_254_740_992.0
        })
    }
}

/// Philox4x32-10: a block of four words of a counter under a key.
fn philox(mut counter: [u32; 4], mut key: [u32; 2]) -> [u32; 4] {
    for round in 0..ROUNDS {
        if round > 0 {
            key = [key[0].wrapping_add(WEYL[0]), key[1].wrapping_add(WEYL[1])];
        }
        let wide = [0, 1].map(|i| u64::from(MULTIPLIERS[i]) * u64::from(counter[2 * i]));
        let [high, low] = [wide.map(|w| (w >> 32) as u32), wide.map(|w| w as u32)];
        counter = [high[1] ^ counter[1] ^ key[0], low[1], high[0] ^ counter[3] ^ key[1], low[0]];
    }
    counter
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_those_that_the_authors_publish() {
        // kat_vectors of Random123: counter, key, block.
        let known = [
            ([0; 4], [0; 2], [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]),
            ([u32::MAX; 4], [u32::MAX; 2], [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]),
            (
                [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
                [0xa409_3822, 0x299f_31d0],
                [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
            ),
        ];
        for (counter, key, block) in known {
            assert_eq!(philox(counter, key), block);
        }
    }

    #[test]
    fn numbers_are_even_and_independent() {
        let pairs: Vec<[f64; 2]> = (0..20_000).map(|i| Stream::new(7, i).uniform(3, 0)).collect();
        let mean = |of: &dyn Fn(&[f64; 2]) -> f64| pairs.iter().map(of).sum::<f64>() / pairs.len() as f64;
        // Three standard errors of each mean.
        assert!((mean(&|p| p[0]) - 0.5).abs() < 3.0 / (12.0f64 * 20_000.0).sqrt());
        assert!((mean(&|p| p[1] * p[1]) - 1.0 / 3.0).abs() < 3.0 * (4.0f64 / 45.0 / 20_000.0).sqrt());
        assert!(mean(&|p| (p[0] - 0.5) * (p[1] - 0.5)).abs() < 3.0 / 12.0 / 20_000f64.sqrt());
    }
}
