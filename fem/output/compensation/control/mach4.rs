//! Mach4: screw map of the Machine Calibration plugin, one map for each direction [MachMotion, Mach 4 Screw Mapping].
//!
//! A start, a length, a number of points at equal distances, and at each the error: "the difference between the
//! expected position and the actual position", which is taken as expected less actual, and told. Builds after 4780
//! (2021) have a map for each direction; before these there is one. The maps are typed into a dialogue, so that this is
//! a list to type in, in mm and to 0.1 um.

use std::fmt::Write;

use super::order::{Control, Order, Written};
use crate::output::number::{fixed, mm};

/// Most points that are written; the page bounds them not, and they are typed in.
const MOST: usize = 1000;

/// Points among which the fewest are sought for targets at uneven distances.
const FEW: usize = 200;

/// Resolution of a value: its last digit, m.
const LEAST: f64 = 1e-7;

/// `--for mach4`.
pub const MACH4: Control =
    Control { name: "mach4", about: "Mach4: a screw map for each direction, to type in", turns: false, write };

fn write(order: &Order) -> Result<Written, String> {
    let mut notes = Vec::new();
    let (grid, taken) = order.evenly(order.both, MOST, FEW, &mut notes)?;
    let table = taken.map(|added, _| (added / LEAST).round() * LEAST);
    let mut text = format!(
        "# start {} mm, length {} mm, {} points\npoint,position [mm],error_positive [mm],error_negative [mm]\n",
        mm(grid.first, 6),
        mm(grid.last() - grid.first, 6),
        grid.points
    );
    for (point, node) in table.nodes.iter().enumerate() {
        let [forward, backward] = [node.forward, node.backward].map(|m| fixed(1e3 * m, 4));
        // Writing to a String does not fail.
        let _ = writeln!(text, "{},{},{forward},{backward}", point + 1, mm(node.position, 6));
    }
    notes.push(
        "type it into Configure, Plugins, Machine Calibration, Linear Compensation; builds after 4780 have a map for each \
         direction, and the backlash of the motor is 0 then"
            .into(),
    );
    notes.push("an error is taken as expected less actual position: look at one point first".into());
    Ok(Written { files: vec![("mach4.csv", text)], table, notes })
}
