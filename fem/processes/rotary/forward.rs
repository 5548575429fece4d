//! Predicts every row: the table where torques, friction, the spring of the drive and its play let it stand, and deviations
//! that are the same from either side.
//!
//! The drive turns the table against its friction T_f, forwards on the one flank of the teeth and backwards on the other.
//! A torque T about the axis, positive towards +, comes to that: what the drive bears is S = T − T_f on the way forwards and
//! S = T + T_f on the way back. Where S < 0 the table hangs back on the flank that drives forwards, by S/k; where S > 0 it
//! leans on the other, and stands farther on by the play too (`joint::give_way`). Where T is larger than T_f the table stays
//! on one flank, and play shows no more. Without any torque the flank is that of the way.

use super::machine::Machine;
use super::rows::{DIRECTION, RUN, TIME_OF_ROW, approach, torque};
use crate::joint::give_way;
use crate::positioning::{Approach, Direction};
use crate::process::Rows;

/// Deviation of every row, rad, from the reading where the axis stands right.
pub fn observe(machine: &Machine, rows: &Rows) -> Vec<f64> {
    let one = |row: usize| {
        let Approach { position: meant, direction, .. } = approach(rows, row);
        let apart = [RUN, DIRECTION].map(|column| rows.columns[column][row]);
        let added = machine.command.as_ref().map_or(0.0, |command| command.at(meant, &apart));
        let angle = meant + added;
        let stands = stands(machine, angle, direction, torque(&machine.setup, rows, row));
        let zero = machine.setup.test.reading_at_zero.unwrap_or(0.0);
        zero + added + stands + machine.error(angle, rows.columns[TIME_OF_ROW][row])
    };
    (0..rows.len()).map(one).collect()
}

/// A torque that moves no table, N·m: what sums of torques leave by round-off is smaller.
const NOTHING: f64 = 1e-9;

/// Where the table stands behind or before the flank that drives it forwards (rad), approached at an angle (rad) under an
/// external torque (N·m).
pub fn stands(machine: &Machine, angle: f64, direction: Direction, external: f64) -> f64 {
    if machine.setup.is_closed() {
        return 0.0;
    }
    let borne = borne(machine, angle, direction, external);
    let flank = match direction {
        // Torques that cancel but for round-off choose no flank.
        Direction::Forward if borne.abs() <= NOTHING => -1.0,
        Direction::Backward if borne.abs() <= NOTHING => 1.0,
        _ => borne,
    };
    give_way(machine.play(angle), borne * machine.compliance, flank)
}

/// Torque that the drive bears (N·m, towards +) where the table has come to an angle (rad) under an external torque (N·m).
pub fn borne(machine: &Machine, angle: f64, direction: Direction, external: f64) -> f64 {
    let friction = if direction == Direction::Forward { -machine.friction } else { machine.friction };
    external + machine.load(angle) + friction
}
