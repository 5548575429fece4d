//! The noise of the measurements: from their own column, from repeats, or estimated from what the model leaves.

use crate::measure::{Measurements, Repeats};

/// Fewer degrees of freedom say too little of a variance.
const LEAST_FREEDOM: usize = 5;

/// Standard uncertainty of each row and where it is known from. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Noise {
    /// Of each row.
    pub sigma: Vec<f64>,
    /// Where from.
    pub source: NoiseSource,
}

/// Where the noise is known from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoiseSource {
    /// The column `u`.
    Column,
    /// Rows that repeat each other.
    Repeats,
    /// The scatter of neighbouring residuals, which a smooth failing of the model hardly touches.
    Estimated,
}

impl Noise {
    /// The best knowledge there is.
    pub fn of(measurements: &Measurements, repeats: &Repeats, residuals: &[f64]) -> Self {
        if let Some(sigma) = &measurements.uncertainty {
            return Self { sigma: sigma.clone(), source: NoiseSource::Column };
        }
        let (sigma, source) = if repeats.freedom >= LEAST_FREEDOM && repeats.sum_of_squares > 0.0 {
            ((repeats.sum_of_squares / repeats.freedom as f64).sqrt(), NoiseSource::Repeats)
        } else {
            // Rounding of what was measured is never less than this.
            let scale = measurements.observed.iter().fold(0.0f64, |m, y| m.max(y.abs()));
            (of_neighbours(residuals).max(1e-9 * scale), NoiseSource::Estimated)
        };
        Self { sigma: vec![sigma; residuals.len()], source }
    }

    /// Root mean square over the rows.
    pub fn rms(&self) -> f64 {
        (self.sigma.iter().map(|s| s * s).sum::<f64>() / self.sigma.len() as f64).sqrt()
    }
}

/// σ from second differences of neighbouring rows, (rᵢ₋₁ − 2rᵢ + rᵢ₊₁)²/6: free of every trend that is straight over
/// three rows. Never zero: residuals that are all alike leave their own round-off.
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
