//! The temperature of a rod at a tool that travels along it and heats it.
//!
//! In every piece the rise is that in an infinite rod of this piece, in closed form (`wave`), plus a
//! remainder: what the ends of the piece send back. The remainder has no source and no kink at the tool, so
//! linear elements graded towards the ends of the pieces and TR-BDF2 steps graded towards both ends of the
//! way through a piece follow it with second order (`rod`), and extrapolation brings about the fourth but for
//! the very first steps. The cost depends on the number of pieces but hardly on the speed, because nothing
//! has to resolve the front ahead of the tool in the middle of a piece.

mod any_loss;
mod mesh;
mod rise;
mod rod;
#[cfg(test)]
mod tests;
mod wave;

pub use any_loss::{AnyLoss, cooled};

use rise::Stretch;
pub(crate) use rise::cubic;
pub use rise::{HeatError, Pass, RodPiece, ToolTemperature};
use rod::Rod;

/// Cells and steps down to this many halvings of the coarsest are tried.
const FINEST: u32 = 5;
/// Lengths below this part of the rod count as zero.
const SLACK: f64 = 1e-9;
/// Seen orders between these allow to extrapolate with order 2.
const ORDERS: std::ops::RangeInclusive<f64> = 1.5..=3.0;

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

/// The pieces in the order in which the tool meets them, equal neighbours joined, and how far from the start
/// of the first the tool starts (m).
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

/// The limit of three meshes of which each halves the cells of the one before, and the estimated error (K/W).
///
/// Only differences that show order 2 are extrapolated with it. The extrapolated values gain about order 4,
/// but only order 1 at the first knot, where one cell and one step have to do; its error halves with it, so
/// half of the difference of two extrapolations bounds the error of the last.
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
