//! Cells and steps that shrink towards the ends of a piece and of a stretch.

use super::RodPiece;
use super::wave::Wave;

/// Growth of the cells on the coarsest mesh at a tolerance of 1; the extrapolated error goes with its fourth
/// power, so that three meshes are enough at most tolerances.
const GROWTH: f64 = 3.8;
/// `smallest` in `graded` over the natural length of the problem, at a tolerance of 1. The rise begins with
/// the root of the time, so the first step and cell leave an error in proportion to this.
const SMALLEST: f64 = 10.0;
/// Tightest and loosest tolerance that still change the coarsest mesh.
const TOLERANCES: [f64; 2] = [1e-6, 1e-3];
/// Last step over the time the tool needs for the steep front ahead of it.
const LAST: f64 = 0.25;
/// Logarithm of how much less than the tolerance the heat may do that is left out.
const MARGIN: f64 = 6.0;
/// No piece and no stretch has more cells or steps than this in a half, on the coarsest mesh.
const MOST: f64 = 1e3;

/// The grading of cells and steps.
pub(super) struct Grading {
    level: u32,
    /// Growth from cell to cell on the coarsest mesh.
    pub(super) growth: f64,
    /// Smallest cell of `graded`, m.
    pub(super) smallest: f64,
    /// Lengths of the front over which heat is forgotten.
    pub(super) reach: f64,
}

impl Grading {
    /// `natural` (m) is the length over which the rise at the tool builds up.
    pub(super) fn new(natural: f64, tolerance: f64, level: u32) -> Self {
        let tolerance = tolerance.clamp(TOLERANCES[0], TOLERANCES[1]);
        let (growth, smallest) = (GROWTH * tolerance.powf(0.25), SMALLEST * tolerance * natural);
        Self { level, growth, smallest, reach: MARGIN - tolerance.ln() }
    }

    /// Times (s) of the steps of a stretch: the rise begins with a root of the time and ends with an
    /// exponential.
    pub(super) fn times(&self, wave: &Wave, duration: f64) -> Vec<f64> {
        let half = 0.5 * duration;
        let roots = graded(half.sqrt(), self.smallest / wave.spread(1.0), 0.5 * self.growth, self.level);
        let first: Vec<f64> = roots.iter().map(|root| root * root).collect();
        let front = wave.front() / (wave.tool(1.0) - wave.tool(0.0));
        joined(&first, &graded(half, LAST * front.min(duration), self.growth, self.level))
    }
}

/// Points from 0 (left out) to `length`: a cell at a distance d from 0 is about `growth` times (`smallest` +
/// d) long. Every level keeps the points of the one before and halves its cells.
pub(super) fn graded(length: f64, smallest: f64, growth: f64, level: u32) -> Vec<f64> {
    let stretch = (growth * length / smallest).ln_1p();
    let count = (stretch / growth).ceil().clamp(2.0, MOST) * f64::from(1_u32 << level);
    (1..=count as u32).map(|i| length * (stretch * f64::from(i) / count).exp_m1() / stretch.exp_m1()).collect()
}

/// Points from 0 to the end of two halves of equal length, each measured from its own end.
pub(super) fn joined(from_start: &[f64], from_end: &[f64]) -> Vec<f64> {
    let length = 2.0 * from_end.last().copied().unwrap_or(0.0);
    let start = std::iter::once(0.0).chain(from_start.iter().copied());
    start.chain(from_end.iter().rev().skip(1).map(|y| length - y)).chain([length]).collect()
}

/// A linear element.
pub(super) struct Element {
    /// A sixth of its heat capacity, J/K.
    pub(super) mass: f64,
    /// Its conductance, W/K.
    stiffness: f64,
    /// A sixth of its loss, W/K.
    loss: f64,
}

impl Element {
    /// `length` (m) of this piece.
    pub(super) fn new(piece: &RodPiece, length: f64) -> Self {
        Self {
            mass: piece.heat_capacity * length / 6.0,
            stiffness: piece.conductance / length,
            loss: piece.loss * length / 6.0,
        }
    }

    /// Diagonal and other entry of mass + `tau` (s) times conductance, J/K.
    pub(super) fn system(&self, tau: f64) -> (f64, f64) {
        (2.0 * self.mass + tau * (self.stiffness + 2.0 * self.loss), self.mass + tau * (self.loss - self.stiffness))
    }
}
