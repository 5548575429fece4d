//! Where a model fails: structure of the residual along every coordinate and every pair of them.
//!
//! Rows are binned along a coordinate, and the means of the bins compared with what the noise alone would scatter them by; and they are
//! held against waves along the coordinate, or along both of a pair, which show what bins average out. Many
//! coordinates are looked at, so that the p-values are multiplied by their number (Bonferroni). Where the noise is only estimated,
//! residuals are shuffled over the rows instead, and the most surprising finding of each shuffle is what a finding has to beat.

use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

use super::chance::Chance;
use super::noise::{Noise, NoiseSource};
use super::waves::{Largest, Waves};
use super::{SIGNIFICANCE, Shape};
use crate::measure::Measurements;
use crate::process::{Coordinate, Holds, Process};
use crate::units::Kind;

/// Bins along one coordinate, and along each of a pair.
const BINS: usize = 12;
const PAIR_BINS: usize = 6;
/// Levels along a coordinate that waves run over; and cells of a pair, of which a coordinate with few levels leaves more to the other.
const LEVELS: usize = 64;
const PAIR_LEVELS: usize = 16;
const CELLS: usize = PAIR_LEVELS * PAIR_LEVELS;
/// Beyond this many rows the estimated noise is as good as known, and shuffles would take long.
const MANY: usize = 20_000;
/// Shuffles of the residuals where the noise is estimated; the smallest p-value is 2/1000.
const SHUFFLES: usize = 999;

/// Along which coordinates, by their position in the process's list: none (everywhere alike), one, or a pair.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis(pub Vec<usize>);

/// Structure that the noise does not explain.
#[derive(Clone, Debug, PartialEq)]
pub struct Feature {
    /// Along what.
    pub axis: Axis,
    /// The coordinates' names.
    pub coordinate: String,
    /// Its shape, along a single coordinate.
    pub shape: Option<Shape>,
    /// Part of the mean square of the residuals that it explains.
    pub share: f64,
    /// How often chance alone shows so much anywhere.
    pub p_value: f64,
    /// One sentence.
    pub text: String,
    /// (coordinate, mean residual) of the bins, in canonical units.
    pub curve: Vec<(f64, f64)>,
    /// Unit of those residuals.
    pub unit: &'static str,
}

/// Rows gathered by one or two coordinates.
struct Binned {
    axis: Axis,
    /// Bin of each row along each coordinate.
    bins: Vec<Vec<usize>>,
    counts: Vec<usize>,
    /// Along the coordinate or both; `None` everywhere.
    waves: Option<Waves>,
}

/// The features that stand out, the largest share first. Observables that stand side by side are looked at one by one.
pub fn find(process: &dyn Process, measurements: &Measurements, residuals: &[f64], noise: &Noise) -> Vec<Feature> {
    let [_, _, ..] = &measurements.seen[..] else { return of_one(process, measurements, residuals, noise) };
    let square = |rows: &[usize]| rows.iter().map(|r| (residuals[*r] / noise.sigma[*r]).powi(2)).sum::<f64>();
    let total = square(&(0..residuals.len()).collect::<Vec<_>>());
    let mut features = Vec::new();
    for (seen, rows) in measurements.seen.iter().zip(measurements.rows_by_observable()) {
        let of = |values: &[f64]| rows.iter().map(|r| values[*r]).collect::<Vec<f64>>();
        let own = Noise { sigma: of(&noise.sigma), source: noise.source };
        let found = of_one(process, &measurements.of(seen), &of(residuals), &own);
        let looks = measurements.seen.len() as f64;
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

/// The features of a single observable.
fn of_one(process: &dyn Process, measurements: &Measurements, residuals: &[f64], noise: &Noise) -> Vec<Feature> {
    let coordinates = process.coordinates();
    let axes = axes(coordinates, measurements);
    let mut z: Vec<f64> = residuals.iter().zip(&noise.sigma).map(|(r, s)| r / s).collect();
    let limit = Limit::new(noise, &axes, &mut z);
    let scores: Vec<Score> = axes.iter().map(|axis| axis.score(&z)).collect();
    let total: f64 = z.iter().map(|z| z * z).sum();
    let kind = measurements.kind();
    let mut features: Vec<Feature> = axes
        .iter()
        .zip(&scores)
        .filter_map(|(axis, score)| {
            let p_value = limit.p_value(axis, score);
            (p_value < SIGNIFICANCE).then(|| {
                let (shape, curve) = axis.describe(coordinates, measurements, residuals, noise, kind);
                let shape = match (&score.wave, shape) {
                    (Some(halves), Some(Shape::Irregular)) => Some(Shape::Periodic { periods: 0.5 * halves[0] as f64 }),
                    (_, shape) => shape,
                };
                let text = sentence(&axis.axis, coordinates, shape.as_ref(), &curve, kind);
                let coordinate = name(&axis.axis, coordinates);
                Feature {
                    axis: axis.axis.clone(),
                    coordinate,
                    shape,
                    share: score.sum / total,
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

/// Everywhere, every coordinate that varies, and every pair of those.
fn axes(coordinates: &[Coordinate], measurements: &Measurements) -> Vec<Binned> {
    let bins = |i: usize, most| bins(&measurements.rows.columns[i], most);
    let together = |i: usize, j: usize| {
        let beside = |other: usize| LEVELS.min(CELLS / bins(other, PAIR_LEVELS).1);
        [bins(i, beside(j)), bins(j, beside(i))]
    };
    let varying: Vec<usize> = (0..coordinates.len())
        .filter(|i| !coordinates[*i].repeats && measurements.given.contains(i) && bins(*i, BINS).1 > 1)
        .collect();
    let mut axes = vec![Binned { axis: Axis(Vec::new()), bins: Vec::new(), counts: Vec::new(), waves: None }];
    for (k, &i) in varying.iter().enumerate() {
        let (of_rows, count) = bins(i, BINS);
        axes.push(Binned {
            axis: Axis(vec![i]),
            bins: vec![of_rows],
            counts: vec![count],
            waves: Some(Waves::new(&[bins(i, LEVELS)])),
        });
        for &j in &varying[k + 1..] {
            let ((a, m), (b, n)) = (bins(i, PAIR_BINS), bins(j, PAIR_BINS));
            axes.push(Binned {
                axis: Axis(vec![i, j]),
                bins: vec![a, b],
                counts: vec![m, n],
                waves: Some(Waves::new(&together(i, j))),
            });
        }
    }
    axes
}

/// The bin of each value, and how many there are: one per distinct value, or `most` with about equally many rows.
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

/// How surprising what an axis shows would be by chance.
struct Score {
    /// Sum of squares of standardised means, or of the largest wave.
    sum: f64,
    /// How often chance gives as much on this axis.
    p_value: f64,
    /// Half periods along each coordinate, where a wave is what shows most.
    wave: Option<Vec<usize>>,
}

impl Score {
    /// Of the cells that hold rows, from which `fitted` means were taken out.
    fn between(sums: &[f64], counts: &[f64], fitted: usize) -> Self {
        let filled = || sums.iter().zip(counts).filter(|(_, count)| **count > 0.0);
        let sum = filled().map(|(sum, count)| sum * sum / count).sum();
        Self::of(sum, filled().count().saturating_sub(fitted).max(1) as f64)
    }

    fn of(sum: f64, freedom: f64) -> Self {
        Self { sum, p_value: ChiSquared::new(freedom).map_or(1.0, |d| d.sf(sum)), wave: None }
    }

    /// The more surprising of bins and waves, at the price of having looked at both.
    fn or(self, other: Option<Self>) -> Self {
        let Some(other) = other else { return self };
        let best = if other.p_value < self.p_value { other } else { self };
        Self { p_value: (2.0 * best.p_value).min(1.0), ..best }
    }
}

impl Binned {
    fn score(&self, z: &[f64]) -> Score {
        let mean = z.iter().sum::<f64>() / z.len() as f64;
        let wave = |largest: Largest| {
            let alone = Score::of(largest.square, largest.freedom);
            let p_value = (alone.p_value * largest.among as f64).min(1.0);
            Score { p_value, wave: Some(largest.halves), ..alone }
        };
        let waves = self.waves.iter().flat_map(|waves| waves.largest(z, mean)).map(wave);
        let waves = waves.min_by(|a, b| a.p_value.total_cmp(&b.p_value));
        self.bins_score(z, mean).or(waves)
    }

    fn bins_score(&self, z: &[f64], mean: f64) -> Score {
        match &self.bins[..] {
            [] => Score::of(z.len() as f64 * mean * mean, 1.0),
            [bins] => {
                let (sums, counts) = gather(bins, self.counts[0], z.iter().map(|z| z - mean));
                Score::between(&sums, &counts, 1)
            }
            [first, second, ..] => interaction(first, second, self.counts[1], self.counts[0], z, mean),
        }
    }

    /// Shape and curve along a single coordinate.
    fn describe(
        &self,
        coordinates: &[Coordinate],
        measurements: &Measurements,
        residuals: &[f64],
        noise: &Noise,
        kind: Kind,
    ) -> (Option<Shape>, Vec<(f64, f64)>) {
        let ([bins], [i]) = (&self.bins[..], &self.axis.0[..]) else { return (None, Vec::new()) };
        let canonical = |v: f64| unit(coordinates[*i].holds).map_or(v, |k| k.from_si(v));
        let values = measurements.rows.columns[*i].iter().map(|v| canonical(*v));
        let (places, counts) = gather(bins, self.counts[0], values);
        let (sums, _) = gather(bins, self.counts[0], residuals.iter().map(|r| kind.from_si(*r)));
        let points: Vec<(f64, f64, f64)> = (0..self.counts[0])
            .filter(|b| counts[*b] > 0.0)
            .map(|b| (places[b] / counts[b], sums[b] / counts[b], counts[b]))
            .collect();
        let variance = kind.from_si(noise.rms()).powi(2);
        (Some(Shape::of(&points, variance)), points.iter().map(|p| (p.0, p.1)).collect())
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

/// What the cells of two coordinates show beyond the sum of what each shows by itself.
fn interaction(first: &[usize], second: &[usize], wide: usize, high: usize, z: &[f64], mean: f64) -> Score {
    let mut left: Vec<f64> = z.iter().map(|z| z - mean).collect();
    // Backfitting: the two take turns to take their means out; balanced designs need one turn.
    for _ in 0..10 {
        for (bins, count) in [(first, high), (second, wide)] {
            let (sums, counts) = gather(bins, count, left.iter().copied());
            left.iter_mut().zip(bins).for_each(|(l, b)| *l -= sums[*b] / counts[*b]);
        }
    }
    let cells: Vec<usize> = first.iter().zip(second).map(|(a, b)| a * wide + b).collect();
    let (sums, counts) = gather(&cells, wide * high, left.into_iter());
    Score::between(&sums, &counts, wide + high - 1)
}

/// What a finding has to beat.
enum Limit {
    /// Number of places looked at.
    Places(f64),
    /// The smallest p-values of each shuffle, rising. A few residuals that are far
    /// larger than the rest make cells of pairs look striking by chance, and would drown what stands along one coordinate.
    Shuffled {
        /// Along single coordinates, and along pairs.
        smallest: [Vec<f64>; 2],
        /// How many rows there are.
        rows: usize,
        /// Their mean square in terms of the noise.
        square: f64,
    },
}

impl Limit {
    /// Of standardised residuals. Those that are shuffled are brought to a mean square of one: measured by a noise that is a small part of them every
    /// shuffle would be too surprising to be told from what they show.
    fn new(noise: &Noise, axes: &[Binned], z: &mut [f64]) -> Self {
        if noise.source != NoiseSource::Estimated || z.len() > MANY {
            return Self::Places(axes.len() as f64);
        }
        let square = (z.iter().map(|z| z * z).sum::<f64>() / z.len() as f64).max(1.0);
        let scale = square.sqrt();
        z.iter_mut().for_each(|z| *z /= scale);
        let mut shuffled = z.to_vec();
        let mut random = Chance::new(0x5EED);
        let mut smallest = [Vec::new(), Vec::new()];
        for _ in 0..SHUFFLES {
            for i in (1..shuffled.len()).rev() {
                shuffled.swap(i, random.below(i + 1));
            }
            // A shuffle cannot change the mean, which is no finding without a known noise.
            for (coordinates, smallest) in (1..).zip(&mut smallest) {
                let own = axes.iter().filter(|a| a.axis.0.len() == coordinates);
                smallest.push(own.map(|a| a.score(&shuffled).p_value).fold(1.0, f64::min));
            }
        }
        smallest.iter_mut().for_each(|s| s.sort_unstable_by(f64::total_cmp));
        Self::Shuffled { smallest, rows: z.len(), square }
    }

    fn p_value(&self, axis: &Binned, score: &Score) -> f64 {
        match (self, axis.axis.0.len()) {
            (Self::Places(places), _) => (score.p_value * places).min(1.0),
            // A shuffle does not change the mean. The noise, from second differences, is known to a third of its rows.
            (Self::Shuffled { rows, square, .. }, 0) => {
                FisherSnedecor::new(1.0, (*rows as f64 / 3.0).max(1.0)).map_or(1.0, |d| d.sf(square * score.sum))
            }
            (Self::Shuffled { smallest, .. }, coordinates) => {
                let own = &smallest[coordinates - 1];
                let below = own.partition_point(|p| *p <= score.p_value);
                // Singles and pairs are both looked at.
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

fn name(axis: &Axis, coordinates: &[Coordinate]) -> String {
    match &axis.0[..] {
        [] => "everywhere".into(),
        several => several.iter().map(|i| coordinates[*i].name).collect::<Vec<_>>().join(" and "),
    }
}

fn sentence(
    axis: &Axis,
    coordinates: &[Coordinate],
    shape: Option<&Shape>,
    curve: &[(f64, f64)],
    kind: Kind,
) -> String {
    let observed = kind.unit;
    let Some(shape) = shape else {
        return match axis.0.len() {
            0 => "the error is off by the same amount everywhere".into(),
            _ => format!("the error along {} changes with the other", name(axis, coordinates)),
        };
    };
    let coordinate = &coordinates[axis.0[0]];
    let along = unit(coordinate.holds).map_or("", |k| k.unit);
    let per = if along.is_empty() { coordinate.name.to_string() } else { along.to_string() };
    match *shape {
        Shape::Linear { slope } => {
            let word = if slope > 0.0 { "grows" } else { "falls" };
            let (from, to) = (curve.first().map_or(0.0, |p| p.0), curve.last().map_or(0.0, |p| p.0));
            let whole = (slope * (to - from)).abs();
            let size = slope.abs();
            format!(
                "the error {word} by {size:.3} {observed} per {per} along {}, {whole:.2} {observed} in all",
                coordinate.name
            )
        }
        Shape::Quadratic { height, at } => {
            let word = if height > 0.0 { "rises" } else { "sinks" };
            let size = height.abs();
            format!(
                "the error {word} in a bow of {size:.2} {observed} along {}, turning at {at:.1} {along}",
                coordinate.name
            )
            .trim_end()
            .into()
        }
        Shape::Step { height, at } => {
            format!("the error steps by {height:+.2} {observed} along {} at {at:.1} {along}", coordinate.name)
                .trim_end()
                .into()
        }
        Shape::Periodic { periods } => {
            format!("the error goes up and down along {}, {periods:.1} periods in all", coordinate.name)
        }
        Shape::Irregular => format!("the error varies along {}, like no line, bow or step", coordinate.name),
    }
}
