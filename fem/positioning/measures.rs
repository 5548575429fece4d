//! In what the positions of an axis and its deviations are told.

use crate::units::{ANGLE, Kind, LENGTH, MICRO, SMALL_ANGLE};

/// The kinds of an axis' positions and of what it is off by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measures {
    /// Kind of a position: mm, deg.
    pub position: Kind,
    /// Kind of a deviation: um, arcsec.
    pub deviation: Kind,
}

impl Measures {
    /// Of an axis that travels along a line.
    pub const LINEAR: Self = Self { position: LENGTH, deviation: MICRO };
    /// Of an axis that turns.
    pub const ROTARY: Self = Self { position: ANGLE, deviation: SMALL_ANGLE };

    /// Whether the axis turns.
    pub fn is_rotary(self) -> bool {
        self == Self::ROTARY
    }

    /// A position (SI) in its unit, without the digits that conversion leaves: nine are kept behind the point.
    pub fn place(self, si: f64) -> f64 {
        (self.position.from_si(si) * 1e9).round() / 1e9 + 0.0
    }

    /// A deviation (SI) in its unit.
    pub fn off(self, si: f64) -> f64 {
        si * (1.0 / self.deviation.canonical().factor)
    }

    /// Unit of positions.
    pub fn position_unit(&self) -> &str {
        &self.position.unit
    }

    /// Unit of deviations.
    pub fn deviation_unit(&self) -> &str {
        &self.deviation.unit
    }
}
