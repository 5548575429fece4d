//! The value of the control for the reversal.

use super::rows::{ANGLE_OF_ROW, DIRECTION, RUN};
use crate::process::{Advice, Rows};
use crate::units::SMALL_ANGLE;

/// Reversals below this are none, rad: a hundredth of a second of arc.
const NONE: f64 = 5e-8;

/// The mean reversal, given the deviation of every row, rad: rows of one run each way, at the same angles.
pub fn advice(rows: &Rows, deviations: &[f64]) -> Vec<Advice> {
    let is_backward = |row: usize| rows.columns[DIRECTION][row] != 0.0;
    let key = |row: usize| (rows.columns[RUN][row].to_bits(), rows.columns[ANGLE_OF_ROW][row].to_bits());
    let forward: std::collections::HashMap<_, f64> =
        (0..rows.len()).filter(|row| !is_backward(*row)).map(|row| (key(row), deviations[row])).collect();
    let differences: Vec<f64> = (0..rows.len())
        .filter(|row| is_backward(*row))
        .filter_map(|row| Some(deviations[row] - forward.get(&key(row))?))
        .collect();
    let mean = differences.iter().sum::<f64>() / differences.len().max(1) as f64;
    if mean.abs() < NONE {
        return Vec::new();
    }
    let text = format!(
        "reversal compensation of {:.2}: the table stands so much farther on when it comes back; a table of angles takes the \
         rest (`fem compensate` makes both of a positioning test)",
        SMALL_ANGLE.shown(mean)
    );
    vec![Advice::new(text)]
}
