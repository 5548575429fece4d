//! The rise at the tool for any film coefficient, from a few that were solved.
//!
//! The rise is an analytic function of the loss. In u = h/(h + h*), with h* the coefficient whose cooling
//! time is a quarter of the pass, it is nearly a polynomial, and the one through the Chebyshev points of 0 ≤
//! u ≤ 10/11 (ends included) follows it closely: a search that tries hundreds of coefficients solves fifteen.

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
    /// A solution at whose knots all rises are given.
    reference: ToolTemperature,
    /// The rise of every point at every knot of the reference, knot after knot.
    rises: Vec<[f64; POINTS]>,
}

/// A Chebyshev point with its barycentric weight.
#[derive(Clone, Copy, Debug)]
struct Point {
    u: f64,
    weight: f64,
}

impl AnyLoss {
    /// Solves for a rod whose pieces carry the loss of a film coefficient of one, to a tolerance relative to
    /// the largest rise.
    ///
    /// # Errors
    /// Those of [`moving_source`].
    pub fn solve(pieces: &[RodPiece], pass: &Pass, tolerance: f64) -> Result<Self, HeatError> {
        let duration = (pass.to - pass.from).abs() / pass.speed;
        let slowest = pieces.iter().map(|p| p.heat_capacity / p.loss).fold(f64::INFINITY, f64::min);
        let half = 4.0 * slowest / duration;
        let end = LARGEST / (LARGEST + 1.0);
        let point = |k: usize| {
            let u = 0.5 * end * (1.0 - (std::f64::consts::PI * k as f64 / (POINTS - 1) as f64).cos());
            let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            Point { u, weight: if k == 0 || k == POINTS - 1 { 0.5 * sign } else { sign } }
        };
        let points: Vec<Point> = (0..POINTS).map(point).collect();
        let solve = |p: &Point| moving_source(&cooled(pieces, half * p.u / (1.0 - p.u)), pass, tolerance);
        let solved: Vec<ToolTemperature> = points.par_iter().map(solve).collect::<Result<_, _>>()?;
        let knots = |rise: &ToolTemperature| rise.stretches.iter().map(|s| s.knots.len()).sum::<usize>();
        let Some(reference) = solved.iter().max_by_key(|rise| knots(rise)).cloned() else {
            return Err(HeatError::Pass);
        };
        let mut rises = Vec::with_capacity(knots(&reference));
        for (i, stretch) in reference.stretches.iter().enumerate() {
            let at =
                |root: f64| std::array::from_fn(|k| solved[k].stretches.get(i).map_or(0.0, |s| s.rise_at(root, 1)));
            rises.extend(stretch.knots.iter().map(|knot| at(knot.root)));
        }
        Ok(Self { half, points, reference, rises })
    }

    /// The largest film coefficient that is covered.
    pub fn largest(&self) -> f64 {
        LARGEST * self.half
    }

    /// The rise at the tool for a film coefficient (barycentric interpolation: Berrut and Trefethen 2004).
    pub fn at(&self, coefficient: f64) -> ToolTemperature {
        let weights = self.weights(coefficient / (coefficient + self.half));
        let mut rise = self.reference.clone();
        let knots = rise.stretches.iter_mut().flat_map(|s| &mut s.knots);
        for (knot, rises) in knots.zip(&self.rises) {
            knot.rise = rises.iter().zip(&weights).map(|(r, w)| r * w).sum();
        }
        rise
    }

    fn weights(&self, u: f64) -> Vec<f64> {
        if let Some(exact) = self.points.iter().position(|p| p.u == u) {
            return (0..POINTS).map(|i| f64::from(u8::from(i == exact))).collect();
        }
        let parts: Vec<f64> = self.points.iter().map(|p| p.weight / (u - p.u)).collect();
        let whole: f64 = parts.iter().sum();
        parts.iter().map(|p| p / whole).collect()
    }
}

/// The pieces with the loss of this film coefficient, when they carry that of one.
pub fn cooled(pieces: &[RodPiece], coefficient: f64) -> Vec<RodPiece> {
    pieces.iter().map(|p| RodPiece { loss: p.loss * coefficient, ..*p }).collect()
}
