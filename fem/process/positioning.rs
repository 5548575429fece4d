//! Interface to processes whose observations are positioning tests, so that `compensate` need not know them by name.

use super::Rows;
use crate::positioning::{Approach, Measures, Steps, Table, Tolerance};

/// A system that moves to targets from either side. SI units: m of a linear axis, rad of a rotary one.
pub trait Positioning {
    /// In what its positions and deviations are told.
    fn measures(&self) -> Measures;

    /// Approach of each row, in their order.
    fn approaches(&self, rows: &Rows) -> Vec<Approach>;

    /// Whether nothing acted on what moves at a row that does not where the axis works.
    fn is_free(&self, rows: &Rows, row: usize) -> bool;

    /// Rows that stand close enough to show what lies between the targets of `rows`, in both directions.
    fn between(&self, rows: &Rows) -> Rows;

    /// Tolerances of the axis.
    fn tolerance(&self) -> Tolerance;

    /// To which a controller rounds its compensation; 0 for none.
    fn resolution(&self) -> f64;

    /// Table by which the controller compensated already during the test; `None` for nothing.
    fn active(&self) -> Option<&Table>;

    /// Points at which the controller takes increments, where they are told.
    fn steps(&self) -> Option<Steps>;

    /// Reading where the axis stands right; `None` where the model does not say.
    fn reading_at_zero(&self) -> Option<f64>;

    /// How far the drive gives way at a position by its own length, m/N: the part of elastic lost motion
    /// that varies along the travel. `None` where no part does.
    fn screw_compliance(&self, position: f64) -> Option<f64>;
}
