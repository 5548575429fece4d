//! The temperature under a tool that travels along a rod and heats it.
//!
//! In every piece of the rod the rise is the one in an infinite rod of that piece, in closed form (`Wave`), plus what
//! the ends of the piece send back. That remainder has no source and no kink at the tool; linear elements, graded
//! towards the ends of the pieces, and TR-BDF2 steps, graded towards both ends of every stretch of the pass, follow it.
//! The mesh and the steps depend on the number of pieces, not on how short `diffusivity / speed` is.

use std::fmt;

mod rod;
mod wave;

use rod::Rod;

/// Meshes up to 2^this times finer than the coarsest are tried.
const FINEST: u32 = 6;
/// Lengths below this part of the rod count as zero.
const SLACK: f64 = 1e-9;

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
    /// Where the tool starts and the rod is cold, m from the start of the first piece.
    pub from: f64,
    /// Where the tool ends, m from the start of the first piece; may lie on either side of `from`.
    pub to: f64,
    /// m/s, above zero.
    pub speed: f64,
}

/// Why [`moving_source`] has no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HeatError {
    /// The rod has no pieces, or this piece (from 0) has a value out of its range.
    Piece(usize),
    /// The pass has no length, leaves the rod or has no positive speed, or the tolerance is not positive.
    Pass,
    /// The finest mesh leaves this estimated error, relative to the largest rise.
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
    direction: f64,
    stretches: Vec<Stretch>,
    error: f64,
}

/// The part of the pass inside one piece.
#[derive(Clone, Debug, Default)]
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

impl ToolTemperature {
    /// Rise at the tool when the tool stands at `x` (m from the start of the first piece), K per W.
    /// Zero before the pass and the last value after it.
    pub fn rise_at(&self, x: f64) -> f64 {
        let distance = (x - self.from) * self.direction;
        let index = self.stretches.partition_point(|stretch| stretch.start <= distance);
        let Some(stretch) = index.checked_sub(1).and_then(|i| self.stretches.get(i)) else { return 0.0 };
        stretch.rise_at((distance - stretch.start).sqrt(), 1)
    }

    /// Estimated largest error of [`rise_at`](Self::rise_at), K per W.
    pub fn error(&self) -> f64 {
        self.error
    }
}

/// Value at `x` of the cubic through the four points nearest to it of the `count` points `(x, value)`, from the third on
/// at least two on either side; fewer points give a lower degree.
fn cubic(x: f64, cell: usize, count: usize, point: impl Fn(usize) -> (f64, f64)) -> f64 {
    let start = cell.saturating_sub(2).min(count.saturating_sub(4));
    let nodes = start..count.min(start + 4);
    let term = |i: usize| {
        let (own, value) = point(i);
        let others = nodes.clone().filter(|&j| j != i).map(|j| point(j).0);
        others.fold(value, |product, other| product * (x - other) / (own - other))
    };
    nodes.clone().map(term).sum()
}

impl Stretch {
    /// The rise (K/W) at this root (m^(1/2)) of the distance from the start, the last one after the end.
    fn rise_at(&self, root: f64, every: usize) -> f64 {
        let cell = self.knots.partition_point(|knot| knot.root < root).div_ceil(every);
        let root = self.knots.last().map_or(0.0, |last| root.min(last.root));
        let point = |i: usize| self.knots.get(i * every).map_or((0.0, 0.0), |knot| (knot.root, knot.rise));
        cubic(root, cell, self.knots.len().div_ceil(every), point)
    }

    /// Estimated largest error (K/W) between the knots.
    fn interpolation_error(&self) -> f64 {
        let error = |knot: &Knot| (self.rise_at(knot.root, 2) - knot.rise).abs();
        self.knots.iter().map(error).fold(0.0, f64::max) / 8.0
    }
}

impl Knot {
    fn new(root: f64, rise: f64) -> Self {
        Self { root, rise }
    }
}

/// Rise at a tool of 1 W on its way along a rod with insulated ends that is cold when the tool starts.
///
/// `tolerance` is relative to the largest rise. The rise is proportional to the power.
///
/// # Errors
/// A rod or pass that makes no sense, or a tolerance that the finest mesh does not reach.
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
        let largest =
            stretches.iter().flat_map(|stretch| &stretch.knots).fold(0.0, |max: f64, knot| max.max(knot.rise));
        relative = error / largest;
        if relative <= tolerance {
            return Ok(ToolTemperature {
                from: pass.from,
                direction: (pass.to - pass.from).signum(),
                stretches,
                error,
            });
        }
        (coarse, middle) = (middle, fine);
    }
    Err(HeatError::Tolerance(relative))
}

/// The pieces in the order the tool meets them, equal neighbours joined, and the distance of its start from the first.
fn travelled(pieces: &[RodPiece], pass: &Pass, tolerance: f64) -> Result<(Vec<RodPiece>, f64), HeatError> {
    let good = |value: f64| value > 0.0 && value.is_finite();
    let fits = |p: &RodPiece| {
        [p.length, p.heat_capacity, p.conductance].iter().all(|&v| good(v)) && (p.loss == 0.0 || good(p.loss))
    };
    if let Some(index) = pieces.iter().position(|piece| !fits(piece)) {
        return Err(HeatError::Piece(index));
    }
    let mut joined: Vec<RodPiece> = Vec::new();
    for piece in pieces {
        match joined.last_mut() {
            Some(last) if RodPiece { length: last.length, ..*piece } == *last => last.length += piece.length,
            _ => joined.push(*piece),
        }
    }
    let length: f64 = joined.iter().map(|piece| piece.length).sum();
    if pieces.is_empty() {
        return Err(HeatError::Piece(0));
    }
    let inside = |x: f64| x >= -SLACK * length && x <= length * (1.0 + SLACK);
    let moves = (pass.to - pass.from).abs() > SLACK * length;
    if !(moves && inside(pass.from) && inside(pass.to) && good(pass.speed) && tolerance > 0.0) {
        return Err(HeatError::Pass);
    }
    if pass.to < pass.from {
        joined.reverse();
        return Ok((joined, length - pass.from));
    }
    Ok((joined, pass.from))
}

/// Where three meshes, each half of the one before, lead, and the estimated error (K/W).
///
/// The error is taken to fall with the square of the cells only if it was seen to; the extrapolated values are then
/// trusted to gain another order 2 (they gain about 4).
fn limit(coarse: &[Stretch], middle: &[Stretch], fine: &[Stretch]) -> (Vec<Stretch>, f64) {
    let (before, after) = (difference(coarse, middle), difference(middle, fine));
    if std::env::var("DBG").is_ok() {
        let p = |c: &[Stretch], f: &[Stretch]| {
            let mut b = (0.0, 0.0, 0);
            for (k, (a, q)) in c.iter().zip(f).enumerate() {
                for (x, y) in a.knots.iter().zip(q.knots.iter().step_by(2)) {
                    let d = (x.rise - y.rise).abs();
                    if d > b.0 {
                        b = (d, x.root * x.root, k)
                    }
                }
            }
            b
        };
        println!("   {:?} {:?} order {:.2}", p(coarse, middle), p(middle, fine), (before / after).log2());
        let (o, n) = (extrapolated(coarse, middle), extrapolated(middle, fine));
        println!(
            "      ext {:?} interp {:?}",
            p(&o, &n),
            n.iter().map(|s| s.interpolation_error()).collect::<Vec<_>>()
        );
    }
    let order = (before / after).log2();
    if (1.5..=2.6).contains(&order) {
        let (older, newer) = (extrapolated(coarse, middle), extrapolated(middle, fine));
        let error = difference(&older, &newer) / 2.0;
        return (newer, error);
    }
    (fine.to_vec(), after)
}

/// Largest difference (K/W) at the knots of `coarse`.
fn difference(coarse: &[Stretch], fine: &[Stretch]) -> f64 {
    let knots = coarse.iter().zip(fine).flat_map(|(a, b)| a.knots.iter().zip(b.knots.iter().step_by(2)));
    knots.map(|(a, b)| (a.rise - b.rise).abs()).fold(0.0, f64::max)
}

/// `fine` plus a third of its difference from `coarse`, at the knots of `fine`.
fn extrapolated(coarse: &[Stretch], fine: &[Stretch]) -> Vec<Stretch> {
    let mut result = fine.to_vec();
    for (stretch, coarse) in result.iter_mut().zip(coarse) {
        let third: Vec<f64> = stretch
            .knots
            .iter()
            .step_by(2)
            .zip(&coarse.knots)
            .map(|(fine, coarse)| (fine.rise - coarse.rise) / 3.0)
            .collect();
        for (i, knot) in stretch.knots.iter_mut().enumerate() {
            knot.rise += 0.5 * (third[i / 2] + third[i.div_ceil(2)]);
        }
    }
    result
}
