//! Rows binned along coordinates and pairs of them, and what the bins and waves show of residuals.

use super::Trend;
use super::waves::{Largest, Waves};
use crate::measure::Measurements;
use crate::noise::beyond_chi2;
use crate::process::{Coordinate, Values};
use crate::units::Kind;

/// Bins along a single coordinate, and along each of a pair.
const BINS: usize = 12;
const PAIR_BINS: usize = 6;
/// Levels of a coordinate over which waves run, and cells of a pair: a coordinate with few levels leaves
/// more cells to the other.
const LEVELS: usize = 64;
const PAIR_LEVELS: usize = 16;
const CELLS: usize = PAIR_LEVELS * PAIR_LEVELS;
/// Coordinates along which a structure lies, by their position in the process's list: none (everywhere
/// alike), one, or a pair.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Along(pub Vec<usize>);

/// Rows binned by none, one or two coordinates.
pub struct Binned {
    /// The coordinates.
    pub along: Along,
    /// Bin of each row along each coordinate.
    bins: Vec<Vec<u16>>,
    counts: Vec<usize>,
    /// Waves along the coordinate or along both; `None` where there is no coordinate.
    waves: Option<Waves>,
}

/// Bins the rows everywhere, along every coordinate that varies, and along every pair of those.
pub fn binnings(coordinates: &[Coordinate], measurements: &Measurements) -> Vec<Binned> {
    let bins = |i: usize, most| bins(&measurements.rows.columns[i], most);
    let together = |i: usize, j: usize| {
        let beside = |other: usize| LEVELS.min(CELLS / bins(other, PAIR_LEVELS).1);
        [bins(i, beside(j)), bins(j, beside(i))]
    };
    let varying: Vec<usize> = (0..coordinates.len())
        .filter(|i| !coordinates[*i].repeats && measurements.given.contains(i) && bins(*i, BINS).1 > 1)
        .collect();
    let mut binnings = vec![Binned { along: Along(Vec::new()), bins: Vec::new(), counts: Vec::new(), waves: None }];
    for (k, &i) in varying.iter().enumerate() {
        let (of_rows, count) = bins(i, BINS);
        binnings.push(Binned {
            along: Along(vec![i]),
            bins: vec![of_rows],
            counts: vec![count],
            waves: Some(Waves::new(&[bins(i, LEVELS)])),
        });
        for &j in &varying[k + 1..] {
            let ((a, m), (b, n)) = (bins(i, PAIR_BINS), bins(j, PAIR_BINS));
            binnings.push(Binned {
                along: Along(vec![i, j]),
                bins: vec![a, b],
                counts: vec![m, n],
                waves: Some(Waves::new(&together(i, j))),
            });
        }
    }
    binnings
}

/// Bin of each value, and number of bins: one per distinct value, or `most` with about equally many rows.
fn bins(values: &Values, most: usize) -> (Vec<u16>, usize) {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| !v.is_nan()).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let levels = sorted.chunk_by(|a, b| a == b).take(most + 1).count();
    let mut starts = match levels > most {
        true => (0..most).map(|k| sorted[k * sorted.len() / most]).collect(),
        false => sorted,
    };
    starts.dedup();
    let bin = |v: &f64| if v.is_nan() { 0 } else { starts.partition_point(|s| s <= v).saturating_sub(1) as u16 };
    (values.iter().map(bin).collect(), starts.len().max(1))
}

/// Test statistic of one binning.
pub struct Statistic {
    /// Sum of squares of the standardised means, or square of the largest wave; χ² under the null
    /// hypothesis.
    pub sum: f64,
    /// Probability that chance gives as much along these coordinates (p-value of this test alone).
    pub p_value: f64,
    /// Half periods along each coordinate, where a wave is the most significant.
    pub wave: Option<Vec<usize>>,
}

impl Statistic {
    /// Statistic of the cells that hold rows, from which `fitted` means were taken out.
    fn between(sums: &[f64], counts: &[f64], fitted: usize) -> Self {
        let filled = || sums.iter().zip(counts).filter(|(_, count)| **count > 0.0);
        let sum = filled().map(|(sum, count)| sum * sum / count).sum();
        Self::of(sum, filled().count().saturating_sub(fitted).max(1) as f64)
    }

    fn of(sum: f64, freedom: f64) -> Self {
        Self { sum, p_value: beyond_chi2(freedom, sum).unwrap_or(1.0), wave: None }
    }

    /// The more significant of bins and waves; its p-value is doubled, for both are tested.
    fn or(self, other: Option<Self>) -> Self {
        let Some(other) = other else { return self };
        let best = if other.p_value < self.p_value { other } else { self };
        Self { p_value: (2.0 * best.p_value).min(1.0), ..best }
    }
}

impl Binned {
    /// Statistic of standardised residuals.
    pub fn statistic(&self, z: &[f64]) -> Statistic {
        let mean = z.iter().sum::<f64>() / z.len() as f64;
        let wave = |largest: Largest| {
            let alone = Statistic::of(largest.square, largest.freedom);
            let p_value = (alone.p_value * largest.among as f64).min(1.0);
            Statistic { p_value, wave: Some(largest.halves), ..alone }
        };
        let waves = self.waves.iter().flat_map(|waves| waves.largest(z, mean)).map(wave);
        let waves = waves.min_by(|a, b| a.p_value.total_cmp(&b.p_value));
        self.of_bins(z, mean).or(waves)
    }

    fn of_bins(&self, z: &[f64], mean: f64) -> Statistic {
        match &self.bins[..] {
            [] => Statistic::of(z.len() as f64 * mean * mean, 1.0),
            [bins] => {
                let (sums, counts) = gather(bins, self.counts[0], z.iter().map(|z| z - mean));
                Statistic::between(&sums, &counts, 1)
            }
            [first, second, ..] => interaction(first, second, self.counts[1], self.counts[0], z, mean),
        }
    }

    /// Trend and curve along a single coordinate.
    pub fn describe(
        &self,
        coordinates: &[Coordinate],
        measurements: &Measurements,
        residuals: &[f64],
        sigma: f64,
        kind: Kind,
    ) -> (Option<Trend>, Vec<(f64, f64)>) {
        let ([bins], [i]) = (&self.bins[..], &self.along.0[..]) else { return (None, Vec::new()) };
        let canonical = |v: f64| coordinates[*i].holds.kind().map_or(v, |k| k.from_si(v));
        let (places, counts) = gather(bins, self.counts[0], measurements.rows.columns[*i].iter().copied());
        let (sums, _) = gather(bins, self.counts[0], residuals.iter().copied());
        let points: Vec<(f64, f64, f64)> = (0..self.counts[0])
            .filter(|b| counts[*b] > 0.0)
            .map(|b| (canonical(places[b] / counts[b]), kind.from_si(sums[b] / counts[b]), counts[b]))
            .collect();
        let variance = kind.from_si(sigma).powi(2);
        (Some(Trend::of(&points, variance)), points.iter().map(|p| (p.0, p.1)).collect())
    }
}

fn gather(bins: &[u16], count: usize, values: impl Iterator<Item = f64>) -> (Vec<f64>, Vec<f64>) {
    let (mut sums, mut counts) = (vec![0.0; count], vec![0.0; count]);
    for (&bin, value) in bins.iter().zip(values) {
        sums[usize::from(bin)] += value;
        counts[usize::from(bin)] += 1.0;
    }
    (sums, counts)
}

/// Interaction of two coordinates: the statistic of their cells beyond the sum of the two main effects.
fn interaction(first: &[u16], second: &[u16], wide: usize, high: usize, z: &[f64], mean: f64) -> Statistic {
    /// Largest mean, in standard uncertainties, that need not be taken out any more.
    const SETTLED: f64 = 1e-3;
    let mut left: Vec<f64> = z.iter().map(|z| z - mean).collect();
    // Backfitting: the means of the one and the other are taken out in turn; balanced designs need one turn.
    for _ in 0..10 {
        let mut largest = 0.0f64;
        for (bins, count) in [(first, high), (second, wide)] {
            let (mut means, counts) = gather(bins, count, left.iter().copied());
            for (mean, count) in means.iter_mut().zip(&counts).filter(|(_, count)| **count > 0.0) {
                *mean /= count;
                largest = largest.max(mean.abs());
            }
            left.iter_mut().zip(bins).for_each(|(l, b)| *l -= means[usize::from(*b)]);
        }
        if largest < SETTLED {
            break;
        }
    }
    let cells: Vec<u16> = first.iter().zip(second).map(|(a, b)| a * wide as u16 + b).collect();
    let (sums, counts) = gather(&cells, wide * high, left.into_iter());
    Statistic::between(&sums, &counts, wide + high - 1)
}
