//! Sobol' sequences with the direction numbers of Joe and Kuo (2008), shifted digit by digit.

use crate::budget::Stream;

/// Binary digits of a coordinate.
const DIGITS: usize = 32;
/// Published numbers: dimension, degree, coefficients, initial numbers.
const TABLE: &str = include_str!("joe-kuo.txt");

/// Most coordinates of a point.
pub const MOST_DIMENSIONS: usize = 256;

/// The first 2³² points of a sequence. A seed shifts all of them by one random number in each coordinate, digit by
/// digit without carries: every point is then even over the cube, and their spacing stays.
#[derive(Clone, Debug)]
pub struct Sobol {
    /// Direction numbers v₁, v₂, … of each coordinate, as digits after the point.
    directions: Vec<[u32; DIGITS]>,
    shift: Vec<u32>,
}

impl Sobol {
    /// The sequence with so many coordinates, at most [`MOST_DIMENSIONS`], and the shift of a seed.
    pub fn new(dimensions: usize, seed: u64) -> Self {
        let stream = Stream::new(seed, u64::MAX);
        let shift = |dimension: u32| (stream.uniform(dimension, 0)[0] * 2f64.powi(DIGITS as i32)) as u32;
        Self { directions: directions(dimensions), shift: (0..dimensions as u32).map(shift).collect() }
    }

    /// A coordinate of point number `index`, in (0, 1).
    pub fn coordinate(&self, index: u32, dimension: usize) -> f64 {
        let digits = (0..DIGITS).filter(|bit| index >> bit & 1 == 1);
        let point = digits.fold(self.shift[dimension], |point, bit| point ^ self.directions[dimension][bit]);
        // Half a step, so that neither end is met.
        (f64::from(point) + 0.5) / 2f64.powi(DIGITS as i32)
    }
}

/// v_i = m_i/2^i, with m_i = 2a₁m_{i−1} ⊕ … ⊕ 2^s m_{i−s} ⊕ m_{i−s} beyond the initial numbers.
fn directions(dimensions: usize) -> Vec<[u32; DIGITS]> {
    let of_first = std::array::from_fn(|i| 1 << (DIGITS - 1 - i));
    let of_row = |line: &str| {
        let numbers: Vec<u32> = line.split_whitespace().filter_map(|word| word.parse().ok()).collect();
        let (degree, a, initial) = (numbers[1] as usize, numbers[2], &numbers[3..]);
        let mut v = [0u32; DIGITS];
        for i in 0..DIGITS {
            v[i] = match initial.get(i) {
                Some(m) => m << (DIGITS - 1 - i),
                None => {
                    let inner = (1..degree).filter(|k| a >> (degree - 1 - k) & 1 == 1).map(|k| v[i - k]);
                    inner.fold(v[i - degree] ^ v[i - degree] >> degree, |sum, term| sum ^ term)
                }
            };
        }
        v
    };
    let rows = TABLE.lines().filter(|line| !line.starts_with('#')).map(of_row);
    std::iter::once(of_first).chain(rows).take(dimensions).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unshifted(dimensions: usize) -> Sobol {
        Sobol { shift: vec![0; dimensions], ..Sobol::new(dimensions, 0) }
    }

    #[test]
    fn the_first_points_are_the_published_ones() {
        // The first ten points in three dimensions, up to their order along Gray's code.
        let sobol = unshifted(3);
        let gray = |i: u32| i ^ i >> 1;
        let known = [
            [0.0, 0.0, 0.0],
            [0.5, 0.5, 0.5],
            [0.75, 0.25, 0.25],
            [0.25, 0.75, 0.75],
            [0.375, 0.375, 0.625],
            [0.875, 0.875, 0.125],
            [0.625, 0.125, 0.875],
            [0.125, 0.625, 0.375],
            [0.1875, 0.3125, 0.9375],
            [0.6875, 0.8125, 0.4375],
        ];
        for (i, point) in (0..).zip(known) {
            let half = 0.5 / 2f64.powi(DIGITS as i32);
            let found = [0, 1, 2].map(|d| sobol.coordinate(gray(i), d) - half);
            assert_eq!(found, point, "point {i}");
        }
    }

    #[test]
    fn every_coordinate_visits_every_stratum_once() {
        for seed in [1, 2] {
            let sobol = Sobol::new(MOST_DIMENSIONS, seed);
            for dimension in 0..MOST_DIMENSIONS {
                let mut seen = [false; 256];
                for index in 256..512 {
                    seen[(256.0 * sobol.coordinate(index, dimension)) as usize] = true;
                }
                assert_eq!(seen, [true; 256], "dimension {dimension}");
            }
        }
        assert_ne!(Sobol::new(1, 1).coordinate(0, 0), Sobol::new(1, 2).coordinate(0, 0));
    }

    #[test]
    fn the_first_two_coordinates_are_even_in_every_elementary_box() {
        // A (0, 10, 2)-net: each box of area 1/1024 holds one of 1024 points.
        let sobol = Sobol::new(2, 5);
        for split in 0..=10 {
            let (columns, rows) = (1 << split, 1 << (10 - split));
            let mut seen = vec![false; 1024];
            for index in 0..1024 {
                let at = |d: usize, parts: u32| (f64::from(parts) * sobol.coordinate(index, d)) as usize;
                seen[at(0, columns) * rows as usize + at(1, rows)] = true;
            }
            assert!(seen.iter().all(|s| *s), "{columns} by {rows}");
        }
    }
}
