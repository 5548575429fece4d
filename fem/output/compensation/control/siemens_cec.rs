//! SINUMERIK 840D sl, 828D, ONE: sag compensation of an axis by itself, `$AN_CEC`, one table for each direction
//! [Siemens, Function Manual Extended Functions, 6FC5397-1BP40-3BA1 (2013), K3, 4.4.3 and 4.4.4; file as in the
//! Function Manual of the 802D sl, 6FC5397-1CP10-5BA0 (2012), 11.3].
//!
//! Values in mm, of a rotary axis in deg, at points of equal distance, linear between them; the first and the last
//! hold beyond the ends.
//! `$AN_CEC_DIRECTION` = 1 and −1 make a table act on the way forwards and backwards alone, which "compensates
//! backlash by position". Machine data 18342 reserves the points of a table; the 828D has 8 tables of 200. The manual
//! prints the sign of `$AA_ENC_COMP` alone, where a positive value moves the axis in the negative direction; the same
//! is taken here, and told. A table of a whole turn is repeated, `$AN_CEC_IS_MODULO` = 1, as with `$AA_ENC_COMP`.

use std::fmt::Write;

use super::order::{Control, Order, Written};
use super::siemens_eec::{FEW, MOST};
use crate::positioning::{Direction, Node};

/// `--for siemens-cec`.
pub const SIEMENS_CEC: Control = Control {
    name: "siemens-cec",
    about: "SINUMERIK 840D sl, 828D, ONE: $AN_CEC, a table for each direction",
    turns: true,
    write,
};

fn write(order: &Order) -> Result<Written, String> {
    let mut notes = Vec::new();
    let (grid, taken) = order.evenly(order.both, MOST, FEW, &mut notes)?;
    let is_round = order.is_round(&grid);
    let taken = if is_round { order.closed(taken, &mut notes) } else { taken };
    let table = order.less_reference(taken, &mut notes).map(|added, _| order.rounded(added));
    let modulo = u8::from(is_round);
    let mut text = String::from("%_N_NC_CEC_INI\nCHANDATA(1)\n");
    let [step, first, last] = [grid.interval, grid.first, grid.last()].map(|si| order.in_units(si));
    let added: [fn(&Node) -> f64; 2] = [|n| n.forward, |n| n.backward];
    for (t, (added, direction)) in added.into_iter().zip(Direction::BOTH).enumerate() {
        // Writing to a String does not fail, here and below.
        for (point, node) in table.nodes.iter().enumerate() {
            let _ = writeln!(text, "$AN_CEC[{t},{point}]={}", order.in_full(-added(node)));
        }
        let axis = order.axis;
        let _ = write!(
            text,
            "$AN_CEC_INPUT_AXIS[{t}]=({axis})\n$AN_CEC_OUTPUT_AXIS[{t}]=({axis})\n$AN_CEC_STEP[{t}]={step}\n\
             $AN_CEC_MIN[{t}]={first}\n$AN_CEC_MAX[{t}]={last}\n$AN_CEC_DIRECTION[{t}]={}1\n\
             $AN_CEC_MULT_BY_TABLE[{t}]=0\n$AN_CEC_IS_MODULO[{t}]={modulo}\n",
            if direction == Direction::Forward { "" } else { "-" }
        );
    }
    text.push_str("M17\n");
    let points = grid.points;
    notes.push(format!(
        "set MD18342 MM_CEC_MAX_POINTS[0] and [1] to {points} at least and MD32450 BACKLASH to 0, for the tables hold the \
         reversal; load with MD32710 CEC_ENABLE = 0, then set it and SD41300 CEC_TABLE_ENABLE[0] and [1] to 1"
    ));
    notes.push(
        "the manual prints no sign for $AN_CEC: that of $AA_ENC_COMP is taken, where a positive value moves the axis in \
         the negative direction. Look at one point first"
            .into(),
    );
    if points > FEW {
        notes.push(format!("the 828D takes {FEW} points in a table, and these are {points}"));
    }
    Ok(Written { files: vec![("siemens-cec.ini", text)], table, notes })
}
