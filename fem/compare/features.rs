//! Finds where a model fails: structure of the residual along every coordinate and every pair of them.
//!
//! Rows are binned along a coordinate, and the means of the bins are compared with the scatter that the
//! noise alone would give them. Rows are also correlated with waves along the coordinate, or along both of a
//! pair, which show what bins average out. The p-values are multiplied by the number of tests (Bonferroni).
//! Where the noise is only estimated, a permutation test takes the place of the table: residuals are
//! shuffled over the rows, and a feature must beat the smallest p-value of each shuffle (max-statistic).

use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

use super::noise::{Noise, NoiseSource};
use super::rng::Rng;
use super::waves::{Largest, Waves};
use super::{SIGNIFICANCE, Trend};
use crate::measure::Measurements;
use crate::process::{Coordinate, Holds, Process};
use crate::units::Kind;

/// Bins along a single coordinate, and along each of a pair.
const BINS: usize = 12;
const PAIR_BINS: usize = 6;
/// Levels of a coordinate over which waves run, and cells of a pair: a coordinate with few levels leaves
/// more cells to the other.
const LEVELS: usize = 64;
const PAIR_LEVELS: usize = 16;
const CELLS: usize = PAIR_LEVELS * PAIR_LEVELS;
/// Number of rows beyond which the estimated noise is as good as known, and shuffles would take long.
const MANY: usize = 20_000;
/// Shuffles of the residuals where the noise is estimated; the smallest p-value is 2/1000.
const SHUFFLES: usize = 999;

/// Coordinates along which a structure lies, by their position in the process's list: none (everywhere
/// alike), one, or a pair.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Along(pub Vec<usize>);

/// Structure that the noise does not explain.
#[derive(Clone, Debug, PartialEq)]
pub struct Feature {
    /// Coordinates along which it lies.
    pub along: Along,
    /// Names of those coordinates.
    pub coordinate: String,
    /// Trend along a single coordinate; `None` along none or a pair.
    pub trend: Option<Trend>,
    /// Share of the mean square of the residuals that it explains.
    pub share: f64,
    /// Probability that chance alone shows as much anywhere (p-value, corrected for all tests).
    pub p_value: f64,
    /// Description in one sentence.
    pub text: String,
    /// Coordinate and mean residual of each bin, in canonical units.
    pub curve: Vec<(f64, f64)>,
    /// Unit of the residuals of the curve.
    pub unit: &'static str,
}

/// Rows binned by none, one or two coordinates.
struct Binned {
    along: Along,
    /// Bin of each row along each coordinate.
    bins: Vec<Vec<usize>>,
    counts: Vec<usize>,
    /// Waves along the coordinate or along both; `None` where there is no coordinate.
    waves: Option<Waves>,
}

/// Finds the significant features, the largest share first. Observables that stand side by side are tested
/// one by one.
pub fn find(process: &dyn Process, measurements: &Measurements, residuals: &[f64], noise: &Noise) -> Vec<Feature> {
    let [_, _, ..] = &measurements.observables[..] else { return of_one(process, measurements, residuals, noise) };
    let square = |rows: &[usize]| rows.iter().map(|r| (residuals[*r] / noise.sigma[*r]).powi(2)).sum::<f64>();
    let total = square(&(0..residuals.len()).collect::<Vec<_>>());
    let mut features = Vec::new();
    for (seen, rows) in measurements.observables.iter().zip(measurements.rows_by_observable()) {
        let of = |values: &[f64]| rows.iter().map(|r| values[*r]).collect::<Vec<f64>>();
        let own = Noise { sigma: of(&noise.sigma), source: noise.source };
        let found = of_one(process, &measurements.of(seen), &of(residuals), &own);
        let looks = measurements.observables.len() as f64;
        features.extend(found.into_iter().map(|f| Feature {
            share: f.share * square(&rows) / total,
            p_value: (f.p_value * looks).min(1.0),
            text: format!("{}: {}", seen.name, f.text),
            ..f
        }));
    }
    features.retain(|f| f.p_value < SIGNIFICANCE);
    features.sort_by(|a, b| b.share.total_cmp(&a.share));
    features
}

/// Finds the features of a single observable.
fn of_one(process: &dyn Process, measurements: &Measurements, residuals: &[f64], noise: &Noise) -> Vec<Feature> {
    let coordinates = process.coordinates();
    let binnings = binnings(coordinates, measurements);
    let mut z: Vec<f64> = residuals.iter().zip(&noise.sigma).map(|(r, s)| r / s).collect();
    let null = NullDistribution::new(noise, &binnings, &mut z);
    let statistics: Vec<Statistic> = binnings.iter().map(|binned| binned.statistic(&z)).collect();
    let total: f64 = z.iter().map(|z| z * z).sum();
    let kind = measurements.kind();
    let mut features: Vec<Feature> = binnings
        .iter()
        .zip(&statistics)
        .filter_map(|(binned, statistic)| {
            let p_value = null.p_value(binned, statistic);
            (p_value < SIGNIFICANCE).then(|| {
                let (trend, curve) = binned.describe(coordinates, measurements, residuals, noise, kind);
                let trend = match (&statistic.wave, trend) {
                    (Some(halves), Some(Trend::Irregular)) => Some(Trend::Periodic { periods: 0.5 * halves[0] as f64 }),
                    (_, trend) => trend,
                };
                let text = sentence(&binned.along, coordinates, trend.as_ref(), &curve, kind);
                let coordinate = name(&binned.along, coordinates);
                Feature {
                    along: binned.along.clone(),
                    coordinate,
                    trend,
                    share: statistic.sum / total,
                    p_value,
                    text,
                    curve,
                    unit: kind.unit,
                }
            })
        })
        .collect();
    features.sort_by(|a, b| b.share.total_cmp(&a.share));
    features
}

/// Bins the rows everywhere, along every coordinate that varies, and along every pair of those.
fn binnings(coordinates: &[Coordinate], measurements: &Measurements) -> Vec<Binned> {
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
fn bins(values: &[f64], most: usize) -> (Vec<usize>, usize) {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| !v.is_nan()).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let mut starts = sorted.clone();
    starts.dedup();
    if starts.len() > most {
        starts = (0..most).map(|k| sorted[k * sorted.len() / most]).collect();
        starts.dedup();
    }
    let bin = |v: &f64| if v.is_nan() { 0 } else { starts.partition_point(|s| s <= v).saturating_sub(1) };
    (values.iter().map(bin).collect(), starts.len().max(1))
}

/// Test statistic of one binning.
struct Statistic {
    /// Sum of squares of the standardised means, or square of the largest wave; χ² under the null
    /// hypothesis.
    sum: f64,
    /// Probability that chance gives as much along these coordinates (p-value of this test alone).
    p_value: f64,
    /// Half periods along each coordinate, where a wave is the most significant.
    wave: Option<Vec<usize>>,
}

impl Statistic {
    /// Statistic of the cells that hold rows, from which `fitted` means were taken out.
    fn between(sums: &[f64], counts: &[f64], fitted: usize) -> Self {
        let filled = || sums.iter().zip(counts).filter(|(_, count)| **count > 0.0);
        let sum = filled().map(|(sum, count)| sum * sum / count).sum();
        Self::of(sum, filled().count().saturating_sub(fitted).max(1) as f64)
    }

    fn of(sum: f64, freedom: f64) -> Self {
        Self { sum, p_value: ChiSquared::new(freedom).map_or(1.0, |d| d.sf(sum)), wave: None }
    }

    /// The more significant of bins and waves; its p-value is doubled, for both are tested.
    fn or(self, other: Option<Self>) -> Self {
        let Some(other) = other else { return self };
        let best = if other.p_value < self.p_value { other } else { self };
        Self { p_value: (2.0 * best.p_value).min(1.0), ..best }
    }
}

impl Binned {
    fn statistic(&self, z: &[f64]) -> Statistic {
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
    fn describe(
        &self,
        coordinates: &[Coordinate],
        measurements: &Measurements,
        residuals: &[f64],
        noise: &Noise,
        kind: Kind,
    ) -> (Option<Trend>, Vec<(f64, f64)>) {
        let ([bins], [i]) = (&self.bins[..], &self.along.0[..]) else { return (None, Vec::new()) };
        let canonical = |v: f64| unit(coordinates[*i].holds).map_or(v, |k| k.from_si(v));
        let values = measurements.rows.columns[*i].iter().map(|v| canonical(*v));
        let (places, counts) = gather(bins, self.counts[0], values);
        let (sums, _) = gather(bins, self.counts[0], residuals.iter().map(|r| kind.from_si(*r)));
        let points: Vec<(f64, f64, f64)> = (0..self.counts[0])
            .filter(|b| counts[*b] > 0.0)
            .map(|b| (places[b] / counts[b], sums[b] / counts[b], counts[b]))
            .collect();
        let variance = kind.from_si(noise.rms()).powi(2);
        (Some(Trend::of(&points, variance)), points.iter().map(|p| (p.0, p.1)).collect())
    }
}

fn gather(bins: &[usize], count: usize, values: impl Iterator<Item = f64>) -> (Vec<f64>, Vec<f64>) {
    let (mut sums, mut counts) = (vec![0.0; count], vec![0.0; count]);
    for (&bin, value) in bins.iter().zip(values) {
        sums[bin] += value;
        counts[bin] += 1.0;
    }
    (sums, counts)
}

/// Interaction of two coordinates: the statistic of their cells beyond the sum of the two main effects.
fn interaction(first: &[usize], second: &[usize], wide: usize, high: usize, z: &[f64], mean: f64) -> Statistic {
    let mut left: Vec<f64> = z.iter().map(|z| z - mean).collect();
    // Backfitting: the means of the one and the other are taken out in turn; balanced designs need one turn.
    for _ in 0..10 {
        for (bins, count) in [(first, high), (second, wide)] {
            let (sums, counts) = gather(bins, count, left.iter().copied());
            left.iter_mut().zip(bins).for_each(|(l, b)| *l -= sums[*b] / counts[*b]);
        }
    }
    let cells: Vec<usize> = first.iter().zip(second).map(|(a, b)| a * wide + b).collect();
    let (sums, counts) = gather(&cells, wide * high, left.into_iter());
    Statistic::between(&sums, &counts, wide + high - 1)
}

/// Null distribution that a statistic has to beat.
enum NullDistribution {
    /// Correction by the number of tests.
    Bonferroni(f64),
    /// Permutation distribution of the smallest p-value, separately for single coordinates and pairs: a few
    /// residuals that are far larger than the rest make cells of pairs look significant by chance, and would
    /// hide a structure along one coordinate.
    Permutation {
        /// Smallest p-value of each shuffle, rising, along single coordinates and along pairs.
        smallest: [Vec<f64>; 2],
        /// Number of rows.
        rows: usize,
        /// Mean square of the standardised residuals before scaling.
        square: f64,
    },
}

impl NullDistribution {
    /// Makes the null distribution of standardised residuals. Residuals that are shuffled are scaled to a
    /// mean square of one: measured by a noise that is a small part of them, every shuffle would be as
    /// significant as they are.
    fn new(noise: &Noise, binnings: &[Binned], z: &mut [f64]) -> Self {
        if noise.source != NoiseSource::Estimated || z.len() > MANY {
            return Self::Bonferroni(binnings.len() as f64);
        }
        let square = (z.iter().map(|z| z * z).sum::<f64>() / z.len() as f64).max(1.0);
        let scale = square.sqrt();
        z.iter_mut().for_each(|z| *z /= scale);
        let mut shuffled = z.to_vec();
        let mut rng = Rng::new(0x5EED);
        let mut smallest = [Vec::new(), Vec::new()];
        for _ in 0..SHUFFLES {
            for i in (1..shuffled.len()).rev() {
                shuffled.swap(i, rng.below(i + 1));
            }
            // A shuffle cannot change the mean, which is no feature without a known noise.
            for (coordinates, smallest) in (1..).zip(&mut smallest) {
                let own = binnings.iter().filter(|a| a.along.0.len() == coordinates);
                smallest.push(own.map(|a| a.statistic(&shuffled).p_value).fold(1.0, f64::min));
            }
        }
        smallest.iter_mut().for_each(|s| s.sort_unstable_by(f64::total_cmp));
        Self::Permutation { smallest, rows: z.len(), square }
    }

    fn p_value(&self, binned: &Binned, statistic: &Statistic) -> f64 {
        match (self, binned.along.0.len()) {
            (Self::Bonferroni(looks), _) => (statistic.p_value * looks).min(1.0),
            // A shuffle does not change the mean. The noise, from second differences, is known to a third of
            // its rows.
            (Self::Permutation { rows, square, .. }, 0) => {
                FisherSnedecor::new(1.0, (*rows as f64 / 3.0).max(1.0)).map_or(1.0, |d| d.sf(square * statistic.sum))
            }
            (Self::Permutation { smallest, .. }, coordinates) => {
                let own = &smallest[coordinates - 1];
                let below = own.partition_point(|p| *p <= statistic.p_value);
                // Single coordinates and pairs are both tested.
                (2.0 * (below + 1) as f64 / (own.len() + 1) as f64).min(1.0)
            }
        }
    }
}

fn unit(holds: Holds) -> Option<Kind> {
    match holds {
        Holds::Quantity(kind) => Some(kind),
        Holds::Number(_) | Holds::Word(_) => None,
    }
}

fn name(along: &Along, coordinates: &[Coordinate]) -> String {
    match &along.0[..] {
        [] => "everywhere".into(),
        several => several.iter().map(|i| coordinates[*i].name).collect::<Vec<_>>().join(" and "),
    }
}

fn sentence(
    along: &Along,
    coordinates: &[Coordinate],
    trend: Option<&Trend>,
    curve: &[(f64, f64)],
    kind: Kind,
) -> String {
    let observed = kind.unit;
    let Some(trend) = trend else {
        return match along.0.len() {
            0 => "the error is off by the same amount everywhere".into(),
            _ => format!("the error along {} changes with the other", name(along, coordinates)),
        };
    };
    let coordinate = &coordinates[along.0[0]];
    let along = unit(coordinate.holds).map_or("", |k| k.unit);
    let per = if along.is_empty() { coordinate.name.to_string() } else { along.to_string() };
    match *trend {
        Trend::Linear { slope } => {
            let word = if slope > 0.0 { "grows" } else { "falls" };
            let (from, to) = (curve.first().map_or(0.0, |p| p.0), curve.last().map_or(0.0, |p| p.0));
            let whole = (slope * (to - from)).abs();
            let size = slope.abs();
            format!(
                "the error {word} by {size:.3} {observed} per {per} along {}, {whole:.2} {observed} in all",
                coordinate.name
            )
        }
        Trend::Quadratic { height, at } => {
            let word = if height > 0.0 { "rises" } else { "sinks" };
            let size = height.abs();
            format!(
                "the error {word} in a bow of {size:.2} {observed} along {}, turning at {at:.1} {along}",
                coordinate.name
            )
            .trim_end()
            .into()
        }
        Trend::Step { height, at } => {
            format!("the error steps by {height:+.2} {observed} along {} at {at:.1} {along}", coordinate.name)
                .trim_end()
                .into()
        }
        Trend::Periodic { periods } => {
            format!("the error goes up and down along {}, {periods:.1} periods in all", coordinate.name)
        }
        Trend::Irregular => format!("the error varies along {}, like no line, bow or step", coordinate.name),
    }
}
