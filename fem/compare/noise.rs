//! Noise of the measurements: from their own column, from repeats, or estimated from the residuals.

use crate::measure::{Measurements, Repeats, Scatter};

/// Fewest degrees of freedom from which a variance is estimated.
const LEAST_FREEDOM: usize = 5;

/// Standard uncertainty of each row, and its source. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// Standard uncertainty of each row.
    pub sigma: Vec<f64>,
    /// Source of the standard uncertainty.
    pub source: NoiseSource,
}

/// Size of the noise of a file. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseLevel {
    /// Root mean square of each of the file's observables.
    pub of: Vec<f64>,
    /// Source of the standard uncertainty.
    pub source: NoiseSource,
}

impl NoiseLevel {
    /// Noise on the scale of the errors of all rows: SI, or 1 where there are several observables.
    pub fn together(&self) -> f64 {
        match self.of[..] {
            [one] => one,
            _ => 1.0,
        }
    }
}

/// Source of the noise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseSource {
    /// The column `u`.
    Column,
    /// Rows that repeat each other (pure error).
    Repeats,
    /// Scatter of neighbouring residuals, which a smooth failing of the model hardly changes.
    Estimated,
}

impl Noise {
    /// Takes the best source there is. Observables that stand side by side each have their own noise.
    pub fn of(measurements: &Measurements, repeats: &Repeats, residuals: &[f64]) -> Self {
        if let Some(sigma) = &measurements.uncertainty {
            return Self { sigma: sigma.clone(), source: NoiseSource::Column };
        }
        let tells = |s: &Scatter| s.freedom >= LEAST_FREEDOM && s.sum_of_squares > 0.0;
        if repeats.scatter.iter().all(tells) {
            let own = |s: &Scatter| (s.sum_of_squares / s.freedom as f64).sqrt();
            return Self::alike(
                measurements,
                &repeats.scatter.iter().map(own).collect::<Vec<_>>(),
                NoiseSource::Repeats,
            );
        }
        let of_rows = |rows: Vec<usize>| {
            // Round-off of the observed values is never less than this.
            let scale = rows.iter().fold(0.0f64, |m, r| m.max(measurements.observed[*r].abs()));
            let residuals: Vec<f64> = in_line(measurements, rows).into_iter().map(|r| residuals[r]).collect();
            of_neighbours(&residuals).max(1e-9 * scale)
        };
        let sigma: Vec<f64> = measurements.rows_by_observable().into_iter().map(of_rows).collect();
        Self::alike(measurements, &sigma, NoiseSource::Estimated)
    }

    /// Gives all rows of an observable the same noise; `sigma` in the order of the file's observables.
    pub fn alike(measurements: &Measurements, sigma: &[f64], source: NoiseSource) -> Self {
        let of_row = |row: usize| sigma[measurements.observable(row)];
        Self { sigma: (0..measurements.len()).map(of_row).collect(), source }
    }

    /// Whether the uncertainties of all rows agree within a ratio.
    pub fn is_about(&self, other: &Self, ratio: f64) -> bool {
        let mut ratios = self.sigma.iter().zip(&other.sigma).map(|(a, b)| a / b);
        ratios.all(|r| (1.0 / ratio..ratio).contains(&r))
    }

    /// Size of the noise of each observable.
    pub fn level(&self, measurements: &Measurements) -> NoiseLevel {
        let own = measurements.observables.iter().map(|s| self.usual(measurements, s.position));
        NoiseLevel { of: own.collect(), source: self.source }
    }

    /// Root mean square over the rows.
    pub fn rms(&self) -> f64 {
        (self.sigma.iter().map(|s| s * s).sum::<f64>() / self.sigma.len() as f64).sqrt()
    }

    /// Root mean square over the rows of an observable, by its position in the process's list; over all rows
    /// where none observes it.
    pub fn usual(&self, measurements: &Measurements, observable: usize) -> f64 {
        let own = || self.sigma.iter().zip(&measurements.rows.observable).filter(|(_, o)| **o == observable);
        match own().count() {
            0 => self.rms(),
            count => (own().map(|(s, _)| s * s).sum::<f64>() / count as f64).sqrt(),
        }
    }
}

/// Orders the rows of one of several observables with neighbours side by side: the coordinate with the most
/// values runs fastest. A file of one observable is taken as it was written.
fn in_line(measurements: &Measurements, mut rows: Vec<usize>) -> Vec<usize> {
    if measurements.observables.len() < 2 {
        return rows;
    }
    let columns = &measurements.rows.columns;
    let levels = |column: &Vec<f64>| {
        let mut values: Vec<f64> = rows.iter().map(|r| column[*r]).filter(|v| !v.is_nan()).collect();
        values.sort_unstable_by(f64::total_cmp);
        values.dedup();
        values.len()
    };
    let mut order: Vec<(usize, &Vec<f64>)> = columns.iter().map(|c| (levels(c), c)).collect();
    order.sort_by_key(|(levels, _)| *levels);
    rows.sort_by(|a, b| {
        let differ = |(_, c): &(usize, &Vec<f64>)| Some(c[*a].total_cmp(&c[*b])).filter(|o| o.is_ne());
        order.iter().find_map(differ).unwrap_or(std::cmp::Ordering::Equal)
    });
    rows
}

/// Estimates σ from second differences of neighbouring rows, (rᵢ₋₁ − 2rᵢ + rᵢ₊₁)²/6, which are free of every
/// trend that is straight over three rows. σ is never zero: residuals that are all alike leave their own
/// round-off.
fn of_neighbours(residuals: &[f64]) -> f64 {
    let mut squares: Vec<f64> = residuals.windows(3).map(|r| (r[0] - 2.0 * r[1] + r[2]).powi(2) / 6.0).collect();
    let largest = residuals.iter().fold(0.0f64, |m, r| m.max(r.abs()));
    let floor = (1e-12 * largest).max(1e-15);
    if squares.is_empty() {
        return largest.max(floor);
    }
    // Steps between parts or set-ups show as outliers: the median of χ²₁ is 0.4549 of its mean.
    squares.sort_unstable_by(f64::total_cmp);
    (squares[squares.len() / 2] / 0.4549).sqrt().max(floor)
}
