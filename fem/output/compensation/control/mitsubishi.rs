//! MITSUBISHI MELDAS C6, C64, E68 and alike: memory-type relative position error compensation, incremental system
//! [Mitsubishi, MELDAS C6/C64 Connection and Maintenance Manual, 9.2; E60/E68 Connection Manual, 9.2].
//!
//! A whole number at each division point but the reference point, −128 to 127. On the positive side of the reference
//! point it is (division interval − actual movement) × 2 for the feed from n − 1 to n, on its negative side (division
//! interval + actual movement) × 2 for the feed from n + 1 to n, the movement being negative there: both are what is
//! added towards larger positions between the two points, in halves of the unit of output, times the compensation
//! scale factor. The sums of the numbers are the rounded table, so that roundings do not add up. The manual shows
//! screens and no file, so that this is a list to type in, with the numbers counted from the reference point.

use std::fmt::Write;

use super::order::{Control, Order, Written, within};
use crate::output::number::mm;
use crate::positioning::Direction;

/// Most division points that are written; the part of the manual that could be read bounds them not.
const MOST: usize = 1024;

/// Least and largest value.
const RANGE: [i64; 2] = [-128, 127];

/// `--for mitsubishi`.
pub const MITSUBISHI: Control = Control {
    name: "mitsubishi",
    about: "MITSUBISHI C6, C64, E68: machine error compensation, incremental",
    turns: false,
    write,
};

fn write(order: &Order) -> Result<Written, String> {
    let mut notes = Vec::new();
    let counted = order.counted(order.one, MOST, &mut notes)?;
    let steps = counted.steps;
    let half = 0.5 * steps.unit;
    let sums = counted.sums(Direction::Forward, half);
    let amounts: Vec<i64> = sums.windows(2).map(|pair| pair[1] - pair[0]).collect();
    within(&amounts, RANGE[0], RANGE[1], steps.magnification)?;
    let mut text = String::from("number,position [mm],amount\n");
    // The way from one point to the next belongs to the one that is farther from the reference point.
    for (lower, amount) in (counted.first..).zip(&amounts) {
        let number = if lower < 0 { lower } else { lower + 1 };
        // Writing to a String does not fail.
        let _ = writeln!(text, "{number},{},{amount}", mm(counted.position(number), 6));
    }
    let backlash = (order.one.backlash() / half).round() * half;
    let forward: Vec<f64> = sums.iter().map(|sum| *sum as f64 * half).collect();
    let backward: Vec<f64> = forward.iter().map(|added| added - backlash).collect();
    notes.push(format!(
        "set the incremental system, the division interval to {} mm, the compensation scale factor to {}, the reference \
         point's division point at {} mm, and the backlash to {} mm; numbers are counted from that division point",
        mm(steps.interval, 6),
        steps.magnification,
        mm(steps.reference, 6),
        mm(backlash, 6)
    ));
    Ok(Written { files: vec![("mitsubishi.csv", text)], table: counted.table(&forward, &backward), notes })
}
