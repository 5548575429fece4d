//! Positioning tests of an axis, linear or rotary: targets that are approached again and again from both sides; their
//! evaluation, and the tables by which a controller makes errors good. Nothing here knows a model or a file.
//! SI units, m of a
//! linear axis and rad of a rotary one; a deviation is the actual less the commanded position.

mod evaluation;
mod grid;
mod measures;
mod pitch;
mod quantity;
mod table;
mod tolerance;

pub use evaluation::{EDITION, Evaluation, Side, Target, goes_around, stand_apart_by};
pub use grid::Grid;
pub use measures::Measures;
pub use pitch::{PitchErrors, Reversal, Step};
pub use quantity::Quantity;
pub use table::{Increment, Law, Node, Steps, Table};
pub use tolerance::{Check, Tolerance};

/// The direction from which a target is approached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Towards larger positions, `+`, ↑.
    Forward,
    /// Towards smaller positions, `-`, ↓.
    Backward,
}

/// One approach to a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Approach {
    /// Commanded position, m.
    pub position: f64,
    /// Direction of the approach.
    pub direction: Direction,
    /// Number of the run.
    pub run: f64,
}

impl Direction {
    /// Both directions, forward first.
    pub const BOTH: [Self; 2] = [Self::Forward, Self::Backward];

    /// The sign that measurement files write.
    pub const fn sign(self) -> &'static str {
        match self {
            Self::Forward => "+",
            Self::Backward => "-",
        }
    }
}
