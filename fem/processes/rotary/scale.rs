//! The scale that reads the angle: a ring on the table, or an encoder on the motor.

use super::drive::Drive;
use crate::input::Reader;
use crate::units::LENGTH;

/// Most lines of a scale that are believed.
const MOST_LINES: usize = 100_000_000;

/// Where a scale is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum At {
    /// On the table.
    Table,
    /// On the motor, behind the gearing.
    Motor,
}

/// Whether the control positions by a scale on the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loop {
    /// It positions by the motor, and the scale only reads.
    Open,
    /// It positions by the scale, so that what the drive is off by is taken out.
    Closed,
}

/// A scale. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// Where it is.
    pub at: At,
    /// Whether the control positions by it.
    pub position_loop: Loop,
    /// Radius of its ring of lines, m, if it is told.
    pub radius: Option<f64>,
    /// Lines on its whole ring, if they are told.
    pub lines: Option<usize>,
}

impl At {
    /// The words of the model file, the default first.
    const WORDS: &[(&'static str, Self)] = &[("table", Self::Table), ("motor", Self::Motor)];
}

impl Loop {
    /// The words of the model file, the default first.
    const WORDS: &[(&'static str, Self)] = &[("open", Self::Open), ("closed", Self::Closed)];
}

impl Scale {
    /// Reads `[scale]`.
    pub fn read(t: &Reader) -> Self {
        let at = t.choice("at", "where the scale is that reads the angle", At::WORDS).or_first(At::Table);
        let about = "whether the control positions by it (closed), or by the motor alone (open)";
        let position_loop = t.choice("loop", about, Loop::WORDS).or_first(Loop::Open);
        let about = "radius of its ring of lines, for its eccentricity";
        let radius = t.quantity("radius", LENGTH, about).positive().optional();
        let lines = t.count("lines", "on its whole ring, for the error within a line").between(1, MOST_LINES);
        if at == At::Motor && position_loop == Loop::Closed {
            let help = "leave `loop` out: a scale on the motor does not see what the drive is off by";
            t.problem("loop", "a loop over the motor's scale leaves the drive outside", help);
        }
        Self { at, position_loop, radius, lines: lines.optional() }
    }

    /// Lines that pass in a turn of the table, if they are told.
    pub fn lines_a_turn(&self, drive: &Drive) -> Option<f64> {
        let turns = if self.at == At::Motor { drive.ratio() } else { 1.0 };
        self.lines.map(|lines| turns * lines as f64)
    }
}
