//! Predicts every row: the slide behind its command after a reversal, and deviations that are the same from either
//! side.
//!
//! The drive pushes the slide against its friction, forwards on the one flank and backwards on the other, and the slide
//! stands behind by what gives way (`joint::give_way`), counted from the flank that drives it forwards. A force that
//! pulls the slide towards - comes to the friction of the way forwards and takes that of the way back off: where it is
//! larger the slide stays on the one flank, and play shows no more.

use super::machine::Machine;
use super::rows::{DIRECTION, PULL, RUN, TIME_OF_ROW, approach};
use crate::joint::give_way;
use crate::positioning::{Approach, Direction};
use crate::process::Rows;

/// Deviation of every row, m, from the reading where the axis stands right: forwards the slide hangs back by the
/// drive's wind-up; backwards too, and by the play besides.
pub fn observe(machine: &Machine, rows: &Rows) -> Vec<f64> {
    let one = |row: usize| {
        let Approach { position: meant, direction, .. } = approach(rows, row);
        let apart = [RUN, DIRECTION].map(|column| rows.columns[column][row]);
        let added = machine.command.as_ref().map_or(0.0, |command| command.at(meant, &apart));
        let position = meant + added;
        let pull = rows.get(PULL, row).unwrap_or(0.0);
        let reversal = match direction {
            _ if pull > 0.0 => {
                let friction = machine.friction(position);
                let driven = pull + if direction == Direction::Forward { friction } else { -friction };
                give_way(machine.play(position), -machine.bend(driven, position), -driven)
            }
            Direction::Forward => give_way(machine.play(position), -machine.wind_up(position), -1.0),
            Direction::Backward => give_way(machine.play(position), machine.wind_up(position), 1.0),
        };
        let time = rows.columns[TIME_OF_ROW][row];
        let errors: f64 = machine.errors.iter().map(|error| error(position, time)).sum();
        let zero = machine.setup.test.reading_at_zero.unwrap_or(0.0);
        zero + added + reversal + machine.setup.growth(position, time) + errors
    };
    (0..rows.len()).map(one).collect()
}
