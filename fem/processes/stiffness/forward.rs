//! Predicts every row from the curve of the joint, and from the structure that it stands on.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use super::curve::Curve;
use super::machine::Machine;
use super::rows::{FORCE_OF_ROW, branch, dial, load, reached};
use crate::process::{Failure, Rows};

/// The displacement of every row of a joint alone, m.
pub fn of_joint(curve: &Curve, rows: &Rows) -> Vec<f64> {
    let curve = Curve { max_force: reached(curve.max_force, rows), ..curve.clone() };
    (0..rows.len()).map(|row| curve.displacement(rows.columns[FORCE_OF_ROW][row], branch(rows, row))).collect()
}

/// The displacement of every row, m: of the joint where the dial watches what is pushed, and everywhere of the structure, to
/// which the joint passes on what friction leaves.
///
/// # Errors
/// The joints of the structure found no equilibrium.
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let curve = &machine.curve;
    let own = of_joint(curve, rows);
    let Some(base) = &machine.setup.base else { return Ok(own) };
    // Dials that watch one push share its equilibrium.
    let mut readings: HashMap<(usize, u64), Vec<f64>> = HashMap::new();
    let of_row = |row: usize| {
        let (load, dial) = (load(rows, row), dial(rows, row));
        let passed_on = curve.spring_force(rows.columns[FORCE_OF_ROW][row], branch(rows, row));
        let own = if base.watches(load, dial) { own[row] } else { curve.offset };
        let all = match readings.entry((load, passed_on.to_bits())) {
            Entry::Occupied(known) => known.into_mut(),
            Entry::Vacant(new) => new.insert(base.readings(load, passed_on)?),
        };
        Ok(own + all[dial])
    };
    (0..rows.len()).map(of_row).collect()
}
