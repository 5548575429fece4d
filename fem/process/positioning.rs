//! Interface to processes whose observations are positioning tests, so that `compensate` need not know them by name.

use super::Rows;
use super::controller::Controller;
use crate::positioning::{Approach, Measures, Tolerance};

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

    /// Compensation in the controller of the axis.
    fn controller(&self) -> &Controller;

    /// Reading where the axis stands right; `None` where the model does not say.
    fn reading_at_zero(&self) -> Option<f64>;

    /// How far the drive gives way at a position by its own length, m/N: the part of elastic lost motion
    /// that varies along the travel. `None` where no part does.
    fn screw_compliance(&self, position: f64) -> Option<f64>;
}

/// By how much targets may stand beyond an axis' travel, as a part of it: people tell a travel in round numbers.
pub const ROUNDED: f64 = 0.02;

/// Places from each target to the next, close enough to show what lies between them.
pub fn finer(targets: &[f64]) -> Vec<f64> {
    /// Places from one target to the next.
    const BETWEEN: usize = 24;
    let fine = |w: &[f64]| {
        let [from, to] = [w[0], w[1]];
        (0..BETWEEN).map(move |i| from + (to - from) * i as f64 / BETWEEN as f64)
    };
    targets.windows(2).flat_map(fine).chain(targets.last().copied()).collect()
}
