//! Places at which a surface is looked at, and what makes it there.

use super::wanted::SAME;

/// Levels nearer than this are equal, m: less than any increment.
pub const EQUAL: f64 = 0.2e-6;
/// Where in an interval its two places stand, by which straight lines and parabolas are weighed exactly.
const GAUSS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// A place at which surfaces are looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Along the part, m.
    pub x: f64,
    /// From the middle of its breadth, m.
    pub y: f64,
    /// Length for which it stands, m.
    pub weight: f64,
    /// The interval along the part in which it stands, m.
    pub interval: [f64; 2],
}

/// What makes the surface at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Made {
    /// The step, by its position.
    pub step: usize,
    /// The share of its way at which it does.
    pub share: f64,
    /// The level, m.
    pub r: f64,
}

/// Evenly spaced places, both ends among them.
pub fn even(low: f64, high: f64, count: usize) -> impl Iterator<Item = f64> {
    (0..=count).map(move |i| low + (high - low) * i as f64 / count as f64)
}

/// Two places between any two borders that lie between two ends, rising, each with its weight and the borders beside
/// it.
pub fn weighed(mut borders: Vec<f64>, (low, high): (f64, f64)) -> Vec<(f64, f64, [f64; 2])> {
    borders.retain(|x| (low..=high).contains(x));
    borders.sort_unstable_by(f64::total_cmp);
    borders.dedup_by(|a, b| *a - *b < SAME);
    let two = |pair: &[f64]| {
        let (from, to) = (pair[0], pair[1]);
        GAUSS.map(|at| (from + at * (to - from), 0.5 * (to - from), [from, to]))
    };
    borders.windows(2).flat_map(two).collect()
}
