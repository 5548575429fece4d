//! Finds where a model fails: structure of the residual along every coordinate and every pair of them.
//!
//! Rows are binned along a coordinate, and the means of the bins are compared with the scatter that the
//! noise alone would give them. Rows are also correlated with waves along the coordinate, or along both of a
//! pair, which show what bins average out. The p-values are multiplied by the number of tests (Bonferroni).
//! Where the noise is only estimated, or scaled by an estimated factor, a permutation test takes the place of
//! the table: residuals are shuffled over the rows, and a feature must beat the smallest p-value of each
//! shuffle (max-statistic).

use rayon::prelude::*;

use super::binning::{Along, Binned, Binnings, Statistic};
use super::rng::Rng;
use super::sentence::{name, sentence};
use super::{SIGNIFICANCE, Trend};
use crate::measure::Measurements;
use crate::noise::{Noise, NoiseSource, beyond_f};
use crate::process::Process;
use crate::units::UnitSymbol;

/// Number of rows beyond which the estimated noise is as good as known, and shuffles would take long.
const MANY: usize = 20_000;
/// Shuffles of the residuals where the noise is estimated; the smallest p-value is 2/1000.
const SHUFFLES: usize = 999;
/// Where the random numbers of the shuffles begin.
const SEED: u64 = 0x5EED;

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
    pub unit: UnitSymbol,
}

/// Finds the significant features, the largest share first. Observables that stand side by side are tested
/// one by one.
pub fn find(process: &dyn Process, measurements: &Measurements, residuals: &[f64], noise: &Noise) -> Vec<Feature> {
    let coordinates = process.coordinates();
    // Made first: values are sorted for it, and a million of them need not lie beside the others.
    let of_all = (measurements.observables.len() == 1).then(|| Binnings::new(coordinates, measurements));
    let left = noise.unshared(residuals);
    let z = noise.whiten(residuals.iter().copied());
    let source = noise.source_of_level();
    let whole = Residuals { sigma: noise.rms(), source, left: &left, z };
    if let Some(binnings) = of_all {
        return of_one(&binnings, whole);
    }
    let square = |rows: &[usize]| rows.iter().map(|r| whole.z[*r].powi(2)).sum::<f64>();
    let total = square(&(0..residuals.len()).collect::<Vec<_>>());
    let mut features = Vec::new();
    for (seen, rows) in measurements.observables.iter().zip(measurements.rows_by_observable()) {
        let of = |values: &[f64]| rows.iter().map(|r| values[*r]).collect::<Vec<f64>>();
        let sigma = noise.usual(measurements, seen.position);
        let left = of(&left);
        let own = Residuals { left: &left, z: of(&whole.z), sigma, source };
        let found = of_one(&Binnings::new(coordinates, &measurements.of(seen)), own);
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

/// Residuals of the rows of one observable, or of all.
struct Residuals<'a> {
    /// Without what effects of the measurement add, SI.
    left: &'a [f64],
    /// Whitened: independent with variance 1 if they are noise.
    z: Vec<f64>,
    /// Root mean square of the noise, SI.
    sigma: f64,
    source: NoiseSource,
}

/// Finds the features of a single observable.
fn of_one(binnings: &Binnings, residuals: Residuals) -> Vec<Feature> {
    let Binnings { coordinates, measurements, .. } = *binnings;
    let Residuals { left, mut z, sigma, source } = residuals;
    let null = NullDistribution::new(source, binnings, &mut z);
    let total: f64 = z.iter().map(|z| z * z).sum();
    let kind = measurements.kind();
    let feature = |along: &Along| {
        let binned = binnings.binned(along);
        let statistic = binned.statistic(&z);
        let p_value = null.p_value(&binned, &statistic);
        (p_value < SIGNIFICANCE).then(|| {
            let (trend, curve) = binned.describe(coordinates, measurements, left, sigma, kind);
            let trend = trend.map(|own| if own.is_flat(&curve) { Trend::Irregular } else { own });
            let trend = match (&statistic.wave, trend) {
                (Some(halves), Some(Trend::Irregular)) => Some(Trend::Periodic { periods: 0.5 * halves[0] as f64 }),
                (_, trend) => trend,
            };
            let text = sentence(along, coordinates, trend.as_ref(), &curve, kind);
            Feature {
                along: along.clone(),
                coordinate: name(along, coordinates),
                trend,
                share: statistic.sum / total,
                p_value,
                text,
                curve,
                unit: kind.unit,
            }
        })
    };
    // Made where they are needed: the bins of all of them together would be more than a file of a million rows.
    let mut features: Vec<Feature> = binnings.all.par_iter().filter_map(feature).collect();
    features.sort_by(|a, b| b.share.total_cmp(&a.share));
    features
}

/// Null distribution that a statistic has to beat.
enum NullDistribution {
    /// Correction by the number of tests.
    Bonferroni(f64),
    /// Permutation distribution of the smallest p-value, separately for single coordinates and pairs: a few
    /// residuals that are far larger than the rest make cells of pairs look significant by chance, and would
    /// hide a structure along one coordinate.
    Permutation {
        /// Smallest p-value of each shuffle, rising, along single coordinates and along pairs; empty where no
        /// shuffle is needed to see that there is nothing.
        smallest: [Vec<f64>; 2],
        /// Number of rows.
        rows: usize,
        /// Mean square of the standardised residuals before scaling.
        square: f64,
    },
}

impl NullDistribution {
    /// Makes the null distribution of standardised residuals.
    fn new(source: NoiseSource, binnings: &Binnings, z: &mut [f64]) -> Self {
        if source != NoiseSource::Estimated || z.len() > MANY {
            return Self::Bonferroni(binnings.all.len() as f64);
        }
        // Residuals that are shuffled are scaled to a mean square of one: measured by a noise that is a small part of
        // them, every shuffle would be as significant as they are.
        let square = (z.iter().map(|z| z * z).sum::<f64>() / z.len() as f64).max(1.0);
        let scale = square.sqrt();
        z.iter_mut().for_each(|z| *z /= scale);
        let order = by_value(binnings, z);
        // A shuffle cannot change the mean, which is no feature without a known noise.
        let smallest = [1, 2].map(|coordinates| {
            let own = binnings.all.iter().filter(|along| along.0.len() == coordinates);
            let own: Vec<Binned> = own.map(|along| binnings.binned(along)).collect();
            smallest_of_shuffles(&own, z, &order)
        });
        Self::Permutation { smallest, rows: z.len(), square }
    }

    fn p_value(&self, binned: &Binned, statistic: &Statistic) -> f64 {
        match (self, binned.along.0.len()) {
            (Self::Bonferroni(looks), _) => (statistic.p_value * looks).min(1.0),
            // A shuffle does not change the mean. The noise, from second differences, is known to a third of
            // its rows.
            (Self::Permutation { rows, square, .. }, 0) => {
                beyond_f(1.0, (*rows as f64 / 3.0).max(1.0), square * statistic.sum).unwrap_or(1.0)
            }
            (Self::Permutation { smallest, .. }, coordinates) => {
                let own = &smallest[coordinates - 1];
                if own.is_empty() {
                    return 1.0;
                }
                let below = own.partition_point(|p| *p <= statistic.p_value);
                // Single coordinates and pairs are both tested.
                (2.0 * (below + 1) as f64 / (own.len() + 1) as f64).min(1.0)
            }
        }
    }
}

/// Rows in an order that does not depend on that of the file: shuffles are the same for the same readings, however they stand.
fn by_value(binnings: &Binnings, z: &[f64]) -> Vec<usize> {
    let columns = &binnings.measurements.rows.columns;
    let mut order: Vec<usize> = (0..z.len()).collect();
    order.sort_by(|a, b| {
        let by_column = columns.iter().map(|column| column[*a].total_cmp(&column[*b]));
        by_column.chain([z[*a].total_cmp(&z[*b])]).find(|own| own.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    });
    order
}

/// The smallest p-value of each of many shuffles, rising; nothing where the values as they stand are far from
/// significant: the smallest of several p-values is below one of them more often than that one itself. Rows are shuffled
/// in an `order` of their own.
fn smallest_of_shuffles(binnings: &[Binned], z: &[f64], order: &[usize]) -> Vec<f64> {
    /// Ratio to the level of significance that allows for p-values from a table.
    const FAR: f64 = 3.0;
    /// Shuffles as significant as the values after which no more are needed, and those that are made together.
    const ENOUGH: usize = 20;
    const BATCH: usize = 111;
    let smallest = |z: &[f64]| binnings.iter().map(|b| b.statistic(z).p_value).fold(1.0, f64::min);
    let own = smallest(z);
    if own > FAR * SIGNIFICANCE {
        return Vec::new();
    }
    let shuffle = |number: usize| {
        let (mut from, mut rng) = (order.to_vec(), Rng::new(SEED + number as u64));
        for i in (1..from.len()).rev() {
            from.swap(i, rng.below(i + 1));
        }
        let mut shuffled = vec![0.0; z.len()];
        order.iter().zip(from).for_each(|(row, from)| shuffled[*row] = z[from]);
        smallest(&shuffled)
    };
    let mut all: Vec<f64> = Vec::new();
    // Shuffles end when enough of them are as significant as the values themselves (Besag and Clifford 1991).
    while all.len() < SHUFFLES && all.iter().filter(|p| **p <= own).count() < ENOUGH {
        let next = all.len()..(all.len() + BATCH).min(SHUFFLES);
        all.extend(next.into_par_iter().map(shuffle).collect::<Vec<f64>>());
    }
    all.sort_unstable_by(f64::total_cmp);
    all
}
