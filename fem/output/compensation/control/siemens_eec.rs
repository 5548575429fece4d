//! SINUMERIK 840D sl, 828D, 808D, ONE: compensation of leadscrew and measuring system, `$AA_ENC_COMP` [Siemens,
//! Function Manual Extended Functions, 6FC5397-1BP40-3BA1 (2013), K3, 4.4.2; 808D Function Manual (01/2017)].
//!
//! Values in mm, of a rotary axis in deg, at points of equal distance, linear between them, one table for both
//! directions. A positive value moves the axis in the negative direction: the value is the deviation, actual less
//! commanded. It should be zero at the reference point. Machine data 38000 reserves the points; the 808D has 200. The backlash value stands in
//! machine data 32450, positive where the encoder leads the machine part [808D Parameter Manual], as it does where the
//! axis lags after a reversal. Values are written to a nanometre; the control bounds neither them nor their number
//! in this text. With `$AA_ENC_COMP_IS_MODULO` = 1 a table is repeated, as it is from 0 to 360 deg [808D Function Manual
//! (01/2017), compensation with modulo function]: the value at MAX is followed by that at MIN, so that both are one here.

use std::fmt::Write;

use super::order::{Control, Order, Written};

/// Points among which the fewest are sought for targets at uneven distances: what the smallest of the controls has.
pub(super) const FEW: usize = 200;

/// Most points that are written.
pub(super) const MOST: usize = 10_000;

/// `--for siemens-eec`.
pub const SIEMENS_EEC: Control = Control {
    name: "siemens-eec",
    about: "SINUMERIK 840D sl, 828D, 808D, ONE: $AA_ENC_COMP, both directions alike",
    turns: true,
    write,
};

fn write(order: &Order) -> Result<Written, String> {
    let (axis, mut notes) = (order.axis, Vec::new());
    let (grid, taken) = order.evenly(order.one, MOST, FEW, &mut notes)?;
    let is_round = order.is_round(&grid);
    let taken = if is_round { order.closed(taken, &mut notes) } else { taken };
    let table = order.less_reference(taken, &mut notes).map(|added, _| order.rounded(added));
    let modulo = u8::from(is_round);
    let mut text = String::from("%_N_AX_EEC_INI\nCHANDATA(1)\n");
    // Writing to a String does not fail, here and below.
    for (point, node) in table.nodes.iter().enumerate() {
        let _ = writeln!(text, "$AA_ENC_COMP[0,{point},{axis}]={}", order.in_full(-node.forward));
    }
    let [step, first, last] = [grid.interval, grid.first, grid.last()].map(|si| order.in_units(si));
    let _ = write!(
        text,
        "$AA_ENC_COMP_STEP[0,{axis}]={step}\n$AA_ENC_COMP_MIN[0,{axis}]={first}\n$AA_ENC_COMP_MAX[0,{axis}]={last}\n\
         $AA_ENC_COMP_IS_MODULO[0,{axis}]={modulo}\nM17\n"
    );
    let (points, backlash, unit) = (grid.points, order.in_full(order.one.backlash()), order.unit());
    notes.push(format!(
        "set MD38000 MM_ENC_COMP_MAX_POINTS to {points} at least and MD32450 BACKLASH to {backlash} {unit}; load with \
         MD32700 ENC_COMP_ENABLE = 0, then set it to 1"
    ));
    if points > FEW {
        notes.push(format!("the 808D takes {FEW} points, and these are {points}"));
    }
    Ok(Written { files: vec![("siemens-eec.ini", text)], table, notes })
}
