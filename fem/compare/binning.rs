//! Rows binned along coordinates and pairs of them, and what the bins and waves show of residuals.

use rayon::prelude::*;

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

/// Every way in which rows are binned: everywhere alike, along every coordinate that varies, and along every pair of
/// those.
pub struct Binnings<'a> {
    /// Coordinates of the process.
    pub coordinates: &'a [Coordinate],
    /// The rows.
    pub measurements: &'a Measurements,
    /// Of each coordinate that varies, by its position.
    quantiles: Vec<(usize, Quantiles)>,
    /// In the order in which they are tested.
    pub all: Vec<Along>,
}

impl<'a> Binnings<'a> {
    /// The ways of binning the rows of a file.
    pub fn new(coordinates: &'a [Coordinate], measurements: &'a Measurements) -> Self {
        let is_sought = |i: &usize| !coordinates[*i].repeats && measurements.given.contains(i);
        let quantiles: Vec<(usize, Quantiles)> = (0..coordinates.len())
            .filter(is_sought)
            .map(|i| (i, Quantiles::of(&measurements.rows.columns[i])))
            .filter(|(_, own)| own.count(BINS) > 1)
            .collect();
        let mut all = vec![Along(Vec::new())];
        for (k, (i, _)) in quantiles.iter().enumerate() {
            all.push(Along(vec![*i]));
            all.extend(quantiles[k + 1..].iter().map(|(j, _)| Along(vec![*i, *j])));
        }
        Self { coordinates, measurements, quantiles, all }
    }

    /// Bins the rows in one of these ways.
    pub fn binned(&self, along: &Along) -> Binned {
        let own = |i: usize| self.quantiles.iter().find(|(own, _)| *own == i).map(|(_, quantiles)| quantiles);
        let bins = |i: usize, most| match own(i) {
            Some(quantiles) => quantiles.bins(&self.measurements.rows.columns[i], most),
            None => (vec![0; self.measurements.len()], 1),
        };
        let levels = |i: usize| own(i).map_or(1, |quantiles| quantiles.count(PAIR_LEVELS));
        let (parts, waves) = match along.0[..] {
            [] => (Vec::new(), None),
            [i] => (vec![bins(i, BINS)], Some(Waves::new(&[bins(i, LEVELS)]))),
            [i, j, ..] => {
                let first = bins(i, LEVELS.min(CELLS / levels(j)));
                // Where many rows share a value there are fewer levels than were asked for, or more than a pair has.
                let second = bins(j, LEVELS.min(CELLS / first.1));
                (vec![bins(i, PAIR_BINS), bins(j, PAIR_BINS)], Some(Waves::new(&[first, second])))
            }
        };
        let (bins, counts) = parts.into_iter().unzip();
        Binned { along: along.clone(), bins, counts, waves }
    }
}

/// Where the values of a coordinate are parted into bins.
struct Quantiles {
    /// The first value of each bin, for one bin at most, for two, up to [`LEVELS`].
    starts: Vec<Vec<f64>>,
}

impl Quantiles {
    /// One bin per distinct value, or as many as are wanted with about equally many rows.
    fn of(values: &Values) -> Self {
        let mut sorted: Vec<f64> = values.iter().copied().filter(|v| !v.is_nan()).collect();
        sorted.par_sort_unstable_by(f64::total_cmp);
        let distinct: Vec<f64> = sorted.chunk_by(|a, b| a == b).take(LEVELS + 1).map(|alike| alike[0]).collect();
        let starts = |most: usize| {
            if distinct.len() <= most {
                return distinct.clone();
            }
            let mut starts: Vec<f64> = (0..most).map(|k| sorted[k * sorted.len() / most]).collect();
            starts.dedup();
            starts
        };
        Self { starts: (1..=LEVELS).map(starts).collect() }
    }

    /// Number of bins where there are `most` of them.
    fn count(&self, most: usize) -> usize {
        self.starts[most - 1].len().max(1)
    }

    /// Bin of each value, and number of bins.
    fn bins(&self, values: &Values, most: usize) -> (Vec<u8>, usize) {
        let starts = &self.starts[most - 1];
        let bin = |v: &f64| if v.is_nan() { 0 } else { starts.partition_point(|s| s <= v).saturating_sub(1) as u8 };
        (values.iter().map(bin).collect(), self.count(most))
    }
}

/// Rows binned by none, one or two coordinates.
pub struct Binned {
    /// The coordinates.
    pub along: Along,
    /// Bin of each row along each coordinate.
    bins: Vec<Vec<u8>>,
    counts: Vec<usize>,
    /// Waves along the coordinate or along both; `None` where there is no coordinate.
    waves: Option<Waves>,
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
        // Of joined files some may not have the coordinate.
        let column = &measurements.rows.columns[*i];
        let placed: Vec<usize> = (0..column.len()).filter(|row| !column[*row].is_nan()).collect();
        let bins: Vec<u8> = placed.iter().map(|row| bins[*row]).collect();
        let (places, counts) = gather(&bins, self.counts[0], placed.iter().map(|row| column[*row]));
        let (sums, _) = gather(&bins, self.counts[0], placed.iter().map(|row| residuals[*row]));
        let points: Vec<(f64, f64, f64)> = (0..self.counts[0])
            .filter(|b| counts[*b] > 0.0)
            .map(|b| (canonical(places[b] / counts[b]), kind.from_si(sums[b] / counts[b]), counts[b]))
            .collect();
        let variance = kind.from_si(sigma).powi(2);
        (Some(Trend::of(&points, variance)), points.iter().map(|p| (p.0, p.1)).collect())
    }
}

fn gather(bins: &[u8], count: usize, values: impl Iterator<Item = f64>) -> (Vec<f64>, Vec<f64>) {
    let (mut sums, mut counts) = (vec![0.0; count], vec![0.0; count]);
    for (&bin, value) in bins.iter().zip(values) {
        sums[usize::from(bin)] += value;
        counts[usize::from(bin)] += 1.0;
    }
    (sums, counts)
}

/// Interaction of two coordinates: the statistic of their cells beyond the sum of the two main effects.
fn interaction(first: &[u8], second: &[u8], wide: usize, high: usize, z: &[f64], mean: f64) -> Statistic {
    /// Largest mean, in standard uncertainties, that need not be taken out any more.
    const SETTLED: f64 = 1e-3;
    let (mut sums, mut counts) = (vec![0.0; wide * high], vec![0.0; wide * high]);
    for ((a, b), z) in first.iter().zip(second).zip(z) {
        let cell = usize::from(*a) * wide + usize::from(*b);
        sums[cell] += z - mean;
        counts[cell] += 1.0;
    }
    // Backfitting: the means of the one and the other are taken out in turn; balanced designs need one turn.
    for _ in 0..10 {
        let cells = |from: usize, step: usize, count: usize| (0..count).map(move |i| from + i * step);
        let of_first = (0..high).map(|a| cells(a * wide, 1, wide));
        let of_second = (0..wide).map(|b| cells(b, wide, high));
        let mut largest = 0.0f64;
        for level in of_first.chain(of_second) {
            let count: f64 = level.clone().map(|cell| counts[cell]).sum();
            if count > 0.0 {
                let mean = level.clone().map(|cell| sums[cell]).sum::<f64>() / count;
                largest = largest.max(mean.abs());
                level.for_each(|cell| sums[cell] -= mean * counts[cell]);
            }
        }
        if largest < SETTLED {
            break;
        }
    }
    Statistic::between(&sums, &counts, wide + high - 1)
}
