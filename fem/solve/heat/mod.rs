//! The temperature of a rod at a tool that travels along it and heats it.
//!
//! In every piece the rise is that in an infinite rod of this piece, in closed form (`wave`), plus a remainder: what
//! the ends of the piece send back. The remainder has no source and no kink at the tool, so linear elements graded
//! towards the ends of the pieces and TR-BDF2 steps graded towards both ends of the way through a piece follow it with
//! second order (`rod`), and extrapolation brings about the fourth but for the very first steps. The cost depends on
//! the number of pieces but hardly on the speed, because nothing has to resolve the front ahead of the tool in the
//! middle of a piece.

mod any_loss;
mod mesh;
mod rod;
#[cfg(test)]
mod tests;
mod wave;

pub use any_loss::{AnyLoss, cooled};

use std::fmt;

use rod::Rod;

/// Cells and steps down to this many halvings of the coarsest are tried.
const FINEST: u32 = 5;
/// Lengths below this part of the rod count as zero.
const SLACK: f64 = 1e-9;
/// Seen orders between these allow to extrapolate with order 2.
const ORDERS: std::ops::RangeInclusive<f64> = 1.5..=3.0;

/// One uniform length of the rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RodPiece {
    /// m, above zero.
    pub length: f64,
    /// Density times specific heat times cross section, J/(m K), above zero.
    pub heat_capacity: f64,
    /// Conductivity times cross section, W m/K, above zero.
    pub conductance: f64,
    /// Film coefficient times perimeter, W/(m K), zero or above.
    pub loss: f64,
}

/// The path of the source.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// Where the tool starts, the whole rod being cold, m from the start of the first piece.
    pub from: f64,
    /// Where the tool ends, m from the start of the first piece; may lie on either side of `from`.
    pub to: f64,
    /// m/s, above zero.
    pub speed: f64,
}

/// Why [`moving_source`] has no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeatError {
    /// This piece (from 0) is missing or has a value out of its range.
    Piece(usize),
    /// The pass has no length, leaves the rod or has no positive speed, or the tolerance is not positive.
    Pass,
    /// The finest mesh leaves this estimated error, relative to the largest rise; NaN after an overflow.
    Tolerance(f64),
}

impl fmt::Display for HeatError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Piece(index) => write!(f, "piece {index} of the rod is missing or has a value out of range"),
            Self::Pass => write!(f, "the tool must move along the rod at a positive speed, to a positive tolerance"),
            Self::Tolerance(error) => write!(f, "the finest mesh leaves an error of {error:.1e} of the largest rise"),
        }
    }
}

impl std::error::Error for HeatError {}

/// The rise of the rod at the tool, as a function of where the tool stands.
#[derive(Clone, Debug)]
pub struct ToolTemperature {
    from: f64,
    /// 1 or -1
    direction: f64,
    stretches: Vec<Stretch>,
    error: f64,
}

impl ToolTemperature {
    /// Rise (K per W) at the tool when it stands at `x` (m from the start of the first piece).
    /// Zero before the pass and the last rise after it.
    pub fn rise_at(&self, x: f64) -> f64 {
        let distance = (x - self.from) * self.direction;
        let index = self.stretches.partition_point(|stretch| stretch.start <= distance);
        let stretch = index.checked_sub(1).and_then(|last| self.stretches.get(last));
        stretch.map_or(0.0, |stretch| stretch.rise_at((distance - stretch.start).sqrt(), 1))
    }

    /// Estimated largest error of [`rise_at`](Self::rise_at), K per W.
    pub fn error(&self) -> f64 {
        self.error
    }
}

/// The way of the tool through one piece.
#[derive(Clone, Debug)]
struct Stretch {
    /// Distance travelled before it, m.
    start: f64,
    knots: Vec<Knot>,
}

/// The rise is a smooth function of the root of the distance from the start of the stretch.
#[derive(Clone, Copy, Debug)]
struct Knot {
    /// m^(1/2)
    root: f64,
    /// K/W
    rise: f64,
}

impl Stretch {
    /// The rise (K/W) at this root (m^(1/2)) from every knot or every second one; the last rise after the end.
    fn rise_at(&self, root: f64, every: usize) -> f64 {
        let root = self.knots.last().map_or(0.0, |last| root.min(last.root));
        let cell = self.knots.partition_point(|knot| knot.root < root).div_ceil(every);
        cubic(root, cell, self.knots.len().div_ceil(every), |i| {
            self.knots.get(i * every).map_or((0.0, 0.0), |knot| (knot.root, knot.rise))
        })
    }

    /// Estimated largest error (K/W) between the knots; the interpolation gains at least order 3.
    fn interpolation_error(&self) -> f64 {
        let error = |knot: &Knot| (self.rise_at(knot.root, 2) - knot.rise).abs();
        self.knots.iter().map(error).fold(0.0, f64::max) / 8.0
    }
}

/// Value at `x` of the cubic through four of `count` points (x, value), two on either side where there are two.
/// `cell` is the first point not left of `x`.
pub(super) fn cubic(x: f64, cell: usize, count: usize, point: impl Fn(usize) -> (f64, f64)) -> f64 {
    let start = cell.saturating_sub(2).min(count.saturating_sub(4));
    let points = start..count.min(start + 4);
    let term = |i: usize| {
        let (own, value) = point(i);
        let others = points.clone().filter(|&j| j != i).map(|j| point(j).0);
        others.fold(value, |product, other| product * (x - other) / (own - other))
    };
    points.clone().map(term).sum()
}

/// Rise at a tool that brings 1 W to a rod with insulated ends, all of it cold when the tool starts.
/// The rise is proportional to the power. `tolerance` is the largest error, relative to the largest rise.
///
/// # Errors
/// A rod, pass or tolerance out of range, or a tolerance that the finest mesh does not reach.
pub fn moving_source(pieces: &[RodPiece], pass: &Pass, tolerance: f64) -> Result<ToolTemperature, HeatError> {
    let (pieces, from) = travelled(pieces, pass, tolerance)?;
    let distance = (pass.to - pass.from).abs();
    let run = |level| Rod::new(&pieces, distance, pass.speed, tolerance, level).pass(from, from + distance);
    let (mut coarse, mut middle) = (run(0), run(1));
    let mut relative = f64::INFINITY;
    for level in 2..=FINEST {
        let fine = run(level);
        let (stretches, error) = limit(&coarse, &middle, &fine);
        let error = stretches.iter().map(Stretch::interpolation_error).fold(error, f64::max);
        let rises = stretches.iter().flat_map(|stretch| &stretch.knots).map(|knot| knot.rise);
        relative = error / rises.fold(0.0, f64::max);
        if relative <= tolerance {
            let direction = (pass.to - pass.from).signum();
            return Ok(ToolTemperature { from: pass.from, direction, stretches, error });
        }
        if relative.is_nan() {
            break;
        }
        (coarse, middle) = (middle, fine);
    }
    Err(HeatError::Tolerance(relative))
}

/// The pieces in the order in which the tool meets them, equal neighbours joined, and how far from the start of the
/// first the tool starts (m).
fn travelled(pieces: &[RodPiece], pass: &Pass, tolerance: f64) -> Result<(Vec<RodPiece>, f64), HeatError> {
    let above = |value: f64| value > 0.0 && value.is_finite();
    let fits = |p: &RodPiece| {
        above(p.length) && above(p.heat_capacity) && above(p.conductance) && (p.loss == 0.0 || above(p.loss))
    };
    if let Some(index) = pieces.iter().position(|piece| !fits(piece)) {
        return Err(HeatError::Piece(index));
    }
    let mut rod: Vec<RodPiece> = Vec::new();
    for piece in pieces {
        match rod.last_mut() {
            Some(last) if *piece == (RodPiece { length: piece.length, ..*last }) => last.length += piece.length,
            _ => rod.push(*piece),
        }
    }
    if rod.is_empty() {
        return Err(HeatError::Piece(0));
    }
    let length: f64 = rod.iter().map(|piece| piece.length).sum();
    let inside = |x: f64| x >= -SLACK * length && x <= length * (1.0 + SLACK);
    let moves = inside(pass.from) && inside(pass.to) && (pass.to - pass.from).abs() > SLACK * length;
    if !(moves && above(pass.speed) && tolerance > 0.0) {
        return Err(HeatError::Pass);
    }
    if pass.to > pass.from {
        return Ok((rod, pass.from));
    }
    rod.reverse();
    Ok((rod, length - pass.from))
}

/// Where three meshes lead of which each halves the cells of the one before, and the estimated error (K/W).
///
/// Only differences that show order 2 are extrapolated with it. The extrapolated values gain about order 4, but only
/// order 1 at the first knot, where one cell and one step have to do; its error halves with it, so half of the
/// difference of two extrapolations bounds the error of the last.
fn limit(coarse: &[Stretch], middle: &[Stretch], fine: &[Stretch]) -> (Vec<Stretch>, f64) {
    let (before, after) = (difference(coarse, middle), difference(middle, fine));
    if !ORDERS.contains(&(before / after).log2()) {
        return (fine.to_vec(), before + after);
    }
    let (older, newer) = (extrapolated(coarse, middle), extrapolated(middle, fine));
    let error = 0.5 * difference(&older, &newer);
    (newer, error)
}

/// Largest difference (K/W) at the knots of `coarse`.
fn difference(coarse: &[Stretch], fine: &[Stretch]) -> f64 {
    let knots = coarse.iter().zip(fine).flat_map(|(a, b)| a.knots.iter().zip(b.knots.iter().step_by(2)));
    knots.map(|(a, b)| (a.rise - b.rise).abs()).fold(0.0, f64::max)
}

/// `fine` plus a third of its difference from `coarse`.
fn extrapolated(coarse: &[Stretch], fine: &[Stretch]) -> Vec<Stretch> {
    let mut result = fine.to_vec();
    for (stretch, coarse) in result.iter_mut().zip(coarse) {
        let common = stretch.knots.iter().step_by(2).zip(&coarse.knots);
        let third: Vec<f64> = common.map(|(fine, coarse)| (fine.rise - coarse.rise) / 3.0).collect();
        for (i, knot) in stretch.knots.iter_mut().enumerate() {
            knot.rise += 0.5 * (third[i / 2] + third[i.div_ceil(2)]);
        }
    }
    result
}
