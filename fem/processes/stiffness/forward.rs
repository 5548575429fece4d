//! Predicts every row from the curve of the joint.

use super::curve::Curve;
use super::rows::{FORCE_OF_ROW, branch, reached};
use crate::process::Rows;

/// The displacement of every row, m.
pub fn observe(curve: &Curve, rows: &Rows) -> Vec<f64> {
    let curve = Curve { max_force: reached(curve.max_force, rows), ..curve.clone() };
    (0..rows.len()).map(|row| curve.displacement(rows.columns[FORCE_OF_ROW][row], branch(rows, row))).collect()
}
