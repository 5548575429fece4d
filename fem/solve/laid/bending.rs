//! How a free beam of several pieces bends under forces that balance.
//!
//! Held at its middle m, a beam that bends and shears yields at x under a force at s on the same side of m, e the nearer of both,
//!
//! ```text
//!     ∫ (x − t)(s − t)/EI dt + ∫ 1/κGA dt        from m to e,
//! ```
//!
//! and not at all under one on the other side. Forces that balance leave nothing to what holds it there, so that a free beam
//! bends alike, but for a rigid motion. What is added here,
//!
//! ```text
//!     f(x) + f(s) − g(x)(s − m) − g(s)(x − m),   f = ½∫ (|x − m| − τ)τ/EI dτ − ½∫ 1/κGA dτ,   g = ±½∫ τ/EI dτ,   τ = |t − m|,
//! ```
//!
//! is rigid or vanishes with the balance, and makes |x − s|³/12EI of a beam of one piece that does not shear: a force then does
//! nothing to its own place, which keeps the forces of supports beside each other apart.

use crate::element::BeamPiece;

/// A beam's flexibility along its length.
#[derive(Clone, Debug, PartialEq)]
pub struct Bending {
    pieces: Vec<Piece>,
    middle: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    from: f64,
    to: f64,
    /// 1/EI.
    flexibility: f64,
    /// 1/κGA.
    shear: f64,
}

impl Bending {
    /// Of pieces from end to end, one at least.
    pub fn new(pieces: &[BeamPiece]) -> Self {
        let mut to = 0.0;
        let of = |piece: &BeamPiece| {
            let from = to;
            to += piece.length;
            Piece { from, to, flexibility: 1.0 / piece.flexural_rigidity, shear: 1.0 / piece.shear_rigidity }
        };
        let pieces = pieces.iter().map(of).collect();
        Self { pieces, middle: 0.5 * to }
    }

    /// What lies between the middle and the nearer of two places on one side of it: of every piece its part there, as its middle
    /// and its length, and itself; none of two sides.
    fn between(&self, x: f64, s: f64) -> impl Iterator<Item = (f64, f64, &Piece)> {
        let [a, b] = [x - self.middle, s - self.middle];
        let near = if a * b <= 0.0 { 0.0 } else { a.abs().min(b.abs()).copysign(a) };
        let (low, high) = (self.middle + near.min(0.0), self.middle + near.max(0.0));
        self.pieces.iter().filter_map(move |piece| {
            let (from, to) = (low.max(piece.from), high.min(piece.to));
            (to > from).then_some((0.5 * (from + to), to - from, piece))
        })
    }

    /// f(x) in m/N and g(x) in rad/N.
    fn beside(&self, x: f64) -> (f64, f64) {
        let far = (x - self.middle).abs();
        let (mut own, mut turn) = (0.0, 0.0);
        for (middle, length, piece) in self.between(x, x) {
            let mean = (middle - self.middle).abs();
            // ∫ τ dτ and ∫ τ² dτ over the piece.
            let (first, second) = (length * mean, length * (mean * mean + length * length / 12.0));
            own += 0.5 * ((far * first - second) * piece.flexibility - length * piece.shear);
            turn += 0.5 * first * piece.flexibility;
        }
        (own, turn.copysign(x - self.middle))
    }

    /// G(x, s), symmetric, m/N.
    pub fn influence(&self, x: f64, s: f64) -> f64 {
        let bent = |(middle, length, piece): (f64, f64, &Piece)| {
            let bent = (x - middle) * (s - middle) + length * length / 12.0;
            length * (bent * piece.flexibility + piece.shear)
        };
        let held: f64 = self.between(x, s).map(bent).sum();
        let ((own, turn), (other, other_turn)) = (self.beside(x), self.beside(s));
        held + own + other - turn * (s - self.middle) - other_turn * (x - self.middle)
    }

    /// How far the section at x turns under a force at s, rad/N: the slope of the line but for what shear adds, and but for
    /// what vanishes with the balance.
    pub fn turned(&self, x: f64, s: f64) -> f64 {
        let turned = |(middle, length, piece): (f64, f64, &Piece)| length * (s - middle) * piece.flexibility;
        self.between(x, s).map(turned).sum::<f64>() - self.beside(s).1
    }
}
