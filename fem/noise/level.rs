//! Size of a noise.

use super::{Acts, Noise, NoiseSource};
use crate::measure::Measurements;

/// Size of the noise of a file. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseLevel {
    /// Root mean square of each of the file's observables.
    pub of: Vec<f64>,
    /// Source of the standard uncertainty.
    pub source: NoiseSource,
    /// Factor by which the stated uncertainties were multiplied for it.
    pub factor: f64,
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

impl Noise {
    /// Whether the uncertainties of all rows agree within a ratio.
    pub fn is_about(&self, other: &Self, ratio: f64) -> bool {
        let mut ratios = self.sigma.iter().zip(other.sigma.iter()).map(|(a, b)| a / b);
        ratios.all(|r| (1.0 / ratio..ratio).contains(&r))
    }

    /// Size of the noise of each observable.
    pub fn level(&self, measurements: &Measurements) -> NoiseLevel {
        let own = measurements.observables.iter().map(|s| self.usual(measurements, s.position));
        let scales = self.terms.iter().filter(|term| matches!(term.effect.acts, Acts::Scales));
        NoiseLevel { of: own.collect(), source: self.source, factor: scales.map(|term| term.size).product() }
    }

    /// Root mean square over the rows that are not weighed down.
    pub fn rms(&self) -> f64 {
        self.rms_of(|_| true).unwrap_or(f64::NAN)
    }

    /// Root mean square over the rows of an observable, by its position in the process's list, without those
    /// that are weighed down; over all rows where none observes it.
    pub fn usual(&self, measurements: &Measurements, observable: usize) -> f64 {
        self.rms_of(|row| measurements.rows.observable[row] == observable).unwrap_or_else(|| self.rms())
    }

    fn rms_of(&self, is_of: impl Fn(usize) -> bool) -> Option<f64> {
        let own = || (0..self.sigma.len()).filter(|row| is_of(*row) && !self.is_weighed_down(*row));
        let count = own().count();
        (count > 0).then(|| (own().map(|row| self.sigma[row].powi(2)).sum::<f64>() / count as f64).sqrt())
    }

    /// Whether a row counts for less than its uncertainty says.
    pub fn is_weighed_down(&self, row: usize) -> bool {
        self.terms.iter().any(|t| matches!(t.effect.acts, Acts::Weighs) && t.rows.contains(&row))
    }
}
