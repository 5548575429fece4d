//! What every row would show: the slide behind its command after a reversal, and deviations that are the
//! same from either side.

use super::machine::Machine;
use super::rows::{TIME_OF_ROW, approach};
use crate::positioning::{Approach, Direction};
use crate::process::Rows;

/// The deviation of every row, m: forwards the slide hangs back by the drive's wind-up; backwards too, and
/// by the play besides.
pub fn observe(machine: &Machine, rows: &Rows) -> Vec<f64> {
    let one = |row: usize| {
        let Approach { position, direction, .. } = approach(rows, row);
        let reversal = match direction {
            Direction::Forward => -machine.wind_up(position),
            Direction::Backward => machine.play(position) + machine.wind_up(position),
        };
        let time = rows.columns[TIME_OF_ROW][row];
        let errors: f64 = machine.errors.iter().map(|error| error(position, time)).sum();
        reversal + machine.setup.growth(position, time) + errors
    };
    (0..rows.len()).map(one).collect()
}
