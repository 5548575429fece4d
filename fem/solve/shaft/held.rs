//! A shaft and what holds it.

use crate::element::BeamPiece;
use crate::solve::plane::Turning;

/// A steady rest: a spring under the shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Distance from the headstock, m.
    pub at: f64,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// How far it stands out of the line of the shaft, m.
    pub offset: f64,
}

/// The hold of the headstock on the shaft's rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// A centre: free to turn.
    Free,
    /// A chuck with this tilting compliance in rad/(N m); 0 is a clamp.
    Compliance(f64),
}

/// A shaft of uniform pieces from the headstock, held in translation there and, where there is a tailstock,
/// at its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaft {
    /// Pieces from the headstock on.
    pub pieces: Vec<BeamPiece>,
    /// Rotation at the headstock.
    pub hold: Hold,
    /// Whether a tailstock holds the far end.
    pub tailstock: bool,
    /// Springs between the ends.
    pub rests: Vec<Rest>,
}

/// The shaft cannot be condensed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShaftError {
    /// A rigid motion is left, or numbers have overflowed.
    #[error("the shaft is loose at x = {at} m: nothing holds it against the tool there")]
    Loose {
        /// Tool position, m.
        at: f64,
    },
    /// A position or a rest off the shaft.
    #[error("x = {at} m is not on the shaft, which is {length} m long")]
    OffTheShaft {
        /// Position, m.
        at: f64,
        /// Length of the shaft, m.
        length: f64,
    },
}

impl Shaft {
    /// Length, m.
    pub fn length(&self) -> f64 {
        let mut length = RunningSum::default();
        self.pieces.iter().for_each(|p| length.add(p.length));
        length.value()
    }

    pub(super) fn turning(&self) -> Turning {
        match self.hold {
            Hold::Free => Turning { p: 1.0, q: 0.0 },
            Hold::Compliance(p) => Turning { p, q: 1.0 },
        }
    }

    /// Whether statics alone gives the supports' forces.
    pub(super) fn is_determinate(&self) -> bool {
        self.rests.is_empty() && !(self.tailstock && self.hold != Hold::Free)
    }
}

/// A sum that is rounded once and not at every step (Neumaier): the last of many short elements is short
/// against the position at which it stands.
#[derive(Clone, Copy, Default)]
pub(super) struct RunningSum {
    sum: f64,
    carry: f64,
}

impl RunningSum {
    pub fn add(&mut self, term: f64) {
        let next = self.sum + term;
        self.carry += if self.sum.abs() >= term.abs() { (self.sum - next) + term } else { (term - next) + self.sum };
        self.sum = next;
    }

    pub fn value(self) -> f64 {
        self.sum + self.carry
    }
}
