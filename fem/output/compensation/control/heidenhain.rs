//! HEIDENHAIN: non-linear axis-error compensation, a table `.COM` that a line of the `.CMA` table names [HEIDENHAIN,
//! Technical Manual MANUALplus 620 (2012), 6.10.3; Technical Manual TNC 407/415/425 (1998), 1.6.3 and 1.6.4].
//!
//! `AXISPOS` in mm from the machine datum, at equal distances, at most 256; the column of the axis' own name holds
//! the values on the way forwards, `BACKLASH` those on the way backwards. Older TNCs want a power of two of 0.1 um as
//! the distance, which `steps` can say. The manuals print a sign for the linear error alone, which is positive
//! where the table travels too far: the deviation, actual less commanded. The same is taken here, and told. The frame
//! (`BEGIN`, `[END]`) is that of a TNC's tool tables. Values are written to 0.1 um.

use std::fmt::Write;

use super::order::{Control, Order, Written};
use crate::output::number::fixed;
use crate::positioning::Node;

/// Most points of a table.
const MOST: usize = 256;

/// Resolution of a value: its last digit, m.
const LEAST: f64 = 1e-7;

/// `--for heidenhain`.
pub const HEIDENHAIN: Control = Control {
    name: "heidenhain",
    about: "HEIDENHAIN: a .COM table of non-linear axis-error compensation",
    turns: false,
    write,
};

fn write(order: &Order) -> Result<Written, String> {
    let (axis, mut notes) = (order.axis, Vec::new());
    let (_, taken) = order.evenly(order.both, MOST, MOST, &mut notes)?;
    let mut text = format!("BEGIN HEIDENHAIN .COM MM\nNR AXISPOS BACKLASH {axis}\n");
    let round = |m: f64| (m / LEAST).round() * LEAST;
    let mut table = taken.map(|added, _| round(added));
    for (number, node) in table.nodes.iter_mut().enumerate() {
        *node = Node { position: round(node.position), ..*node };
        let [at, backward, forward] = [node.position, -node.backward, -node.forward].map(|m| fixed(1e3 * m, 4));
        // Writing to a String does not fail.
        let _ = writeln!(text, "{number} {at} {backward} {forward}");
    }
    text.push_str("[END]\n");
    notes.push(format!(
        "positions are from the machine datum; name the table in the column {axis} of a line of the .CMA table and mark \
         the line with * in ACTIVE; set the backlash of the axis to 0, for the table holds the reversal"
    ));
    notes.push(
        "the manuals print a sign for the linear error alone, positive where the axis goes too far: it is taken here \
         too. Look at one point first"
            .into(),
    );
    Ok(Written { files: vec![("heidenhain.com", text)], table, notes })
}
