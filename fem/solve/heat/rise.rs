//! A rod, the pass of a tool along it, and the rise at the tool.

use std::fmt;

/// One uniform length of the rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RodPiece {
    /// Length, m, above zero.
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
    /// Start of the tool, the whole rod being cold, m from the start of the first piece.
    pub from: f64,
    /// End of the tool's way, m from the start of the first piece; may lie on either side of `from`.
    pub to: f64,
    /// Speed of the tool, m/s, above zero.
    pub speed: f64,
}

/// Why [`moving_source`](super::moving_source) has no answer.
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
    pub(super) from: f64,
    /// 1 or -1
    pub(super) direction: f64,
    pub(super) stretches: Vec<Stretch>,
    pub(super) error: f64,
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
pub(super) struct Stretch {
    /// Distance travelled before it, m.
    pub(super) start: f64,
    pub(super) knots: Vec<Knot>,
}

/// The rise is a smooth function of the root of the distance from the start of the stretch.
#[derive(Clone, Copy, Debug)]
pub(super) struct Knot {
    /// Root of the distance, m^(1/2).
    pub(super) root: f64,
    /// Rise per power, K/W.
    pub(super) rise: f64,
}

impl Stretch {
    /// The rise (K/W) at this root (m^(1/2)) from every knot or every second one; the last rise after the
    /// end.
    pub(super) fn rise_at(&self, root: f64, every: usize) -> f64 {
        let root = self.knots.last().map_or(0.0, |last| root.min(last.root));
        let cell = self.knots.partition_point(|knot| knot.root < root).div_ceil(every);
        cubic(root, cell, self.knots.len().div_ceil(every), |i| {
            self.knots.get(i * every).map_or((0.0, 0.0), |knot| (knot.root, knot.rise))
        })
    }

    /// Estimated largest error (K/W) between the knots; the interpolation gains at least order 3.
    pub(super) fn interpolation_error(&self) -> f64 {
        let error = |knot: &Knot| (self.rise_at(knot.root, 2) - knot.rise).abs();
        self.knots.iter().map(error).fold(0.0, f64::max) / 8.0
    }
}

/// Value at `x` of the cubic through four of `count` points (x, value), two on either side where there are
/// two. `cell` is the first point not left of `x`.
pub(crate) fn cubic(x: f64, cell: usize, count: usize, point: impl Fn(usize) -> (f64, f64)) -> f64 {
    let start = cell.saturating_sub(2).min(count.saturating_sub(4));
    let points = start..count.min(start + 4);
    let term = |i: usize| {
        let (own, value) = point(i);
        let others = points.clone().filter(|&j| j != i).map(|j| point(j).0);
        others.fold(value, |product, other| product * (x - other) / (own - other))
    };
    points.clone().map(term).sum()
}
