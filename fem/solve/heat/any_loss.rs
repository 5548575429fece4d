//! The rise at the tool for any film coefficient, from a few that were solved.
//!
//! The rise is an analytic function of the loss. In u = h/(h + h*), with h* the coefficient whose cooling time is a quarter of the pass, it is
//! nearly a polynomial, and the one through the Chebyshev points of 0 ≤ u ≤ 10/11 (ends included) follows it closely: a search that tries hundreds
//! of coefficients solves fifteen.

use rayon::prelude::*;

use super::{HeatError, Pass, RodPiece, ToolTemperature, moving_source};

/// Chebyshev points: the error falls by about two and a half with each.
const POINTS: usize = 15;
/// Largest coefficient, in units of h*.
const LARGEST: f64 = 10.0;

/// Rises at the tool over film coefficients from zero to [`AnyLoss::largest`].
#[derive(Clone, Debug)]
pub struct AnyLoss {
    half: f64,
    points: Vec<Point>,
}

#[derive(Clone, Debug)]
struct Point {
    u: f64,
    weight: f64,
    rise: ToolTemperature,
}

impl AnyLoss {
    /// For a rod whose pieces carry the loss of a film coefficient of one, to a tolerance relative to the largest rise.
    ///
    /// # Errors
    /// As of [`moving_source`].
    pub fn solve(pieces: &[RodPiece], pass: &Pass, tolerance: f64) -> Result<Self, HeatError> {
        let duration = (pass.to - pass.from).abs() / pass.speed;
        let slowest = pieces.iter().map(|p| p.heat_capacity / p.loss).fold(f64::INFINITY, f64::min);
        let half = 4.0 * slowest / duration;
        let end = LARGEST / (LARGEST + 1.0);
        let point = |k: usize| {
            let u = 0.5 * end * (1.0 - (std::f64::consts::PI * k as f64 / (POINTS - 1) as f64).cos());
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let weight = if k == 0 || k == POINTS - 1 { 0.5 * sign } else { sign };
            let rise = moving_source(&cooled(pieces, half * u / (1.0 - u)), pass, tolerance)?;
            Ok(Point { u, weight, rise })
        };
        let points: Result<Vec<Point>, HeatError> = (0..POINTS).into_par_iter().map(point).collect();
        Ok(Self { half, points: points? })
    }

    /// The largest film coefficient that is covered.
    pub fn largest(&self) -> f64 {
        LARGEST * self.half
    }

    /// The weight of each solved rise at a film coefficient (barycentric: Berrut and Trefethen 2004).
    pub fn at(&self, coefficient: f64) -> Vec<f64> {
        let u = coefficient / (coefficient + self.half);
        if let Some(exact) = self.points.iter().position(|p| p.u == u) {
            return (0..POINTS).map(|i| f64::from(u8::from(i == exact))).collect();
        }
        let parts: Vec<f64> = self.points.iter().map(|p| p.weight / (u - p.u)).collect();
        let whole: f64 = parts.iter().sum();
        parts.iter().map(|p| p / whole).collect()
    }

    /// The rise at `x` (K per W) with the weights of a film coefficient.
    pub fn rise_at(&self, x: f64, weights: &[f64]) -> f64 {
        self.points.iter().zip(weights).map(|(p, w)| w * p.rise.rise_at(x)).sum()
    }
}

/// The pieces with the loss of this film coefficient, when they carry that of one.
pub fn cooled(pieces: &[RodPiece], coefficient: f64) -> Vec<RodPiece> {
    pieces.iter().map(|p| RodPiece { loss: p.loss * coefficient, ..*p }).collect()
}
