//! Beckhoff TwinCAT CNC and other controls with the ISG kernel: leadscrew error compensation, a compensation value list
//! `achskw*.lis` [Beckhoff, TF5200 TwinCAT 3 CNC, Axis compensation (FCT-C5), P-COMP-00017 to 00024 and 00059].
//!
//! `kw.ssfk.*` with `unit` = 1: whole numbers of 0.1 um. With `interval` = 0 every point has its own position, at any
//! distances; there are fewer than 1500 unless P-COMP-00059 says otherwise. The value is actual less commanded, for
//! each direction (`bilateral` = 1), linear between the points; the first and the last hold beyond the ends.

use std::fmt::Write;

use super::order::{Control, Order, Written};
use crate::positioning::Node;

/// Most points of a list, by default.
const MOST: usize = 1499;

/// Unit of positions and values, m.
const UNIT: f64 = 1e-7;

/// `--for beckhoff`.
pub const BECKHOFF: Control = Control {
    name: "beckhoff",
    about: "Beckhoff TwinCAT CNC, ISG kernel: kw.ssfk, a value for each direction",
    turns: false,
    write,
};

fn write(order: &Order) -> Result<Written, String> {
    let points = order.both.nodes.len();
    if points > MOST {
        return Err(format!("{points} targets are more than the {MOST} that it takes"));
    }
    let counts = |m: f64| (m / UNIT).round();
    let mut table = order.both.map(|added, _| counts(added) * UNIT);
    for node in &mut table.nodes {
        *node = Node { position: counts(node.position) * UNIT, ..*node };
    }
    let start = table.nodes.first().map_or(0.0, |n| counts(n.position));
    let mut text = format!(
        "kopf.achs_nr 1\nkopf.log_achs_name {}\nkw.ssfk.unit 1\nkw.ssfk.interval 0\nkw.ssfk.kw_startpos {start:.0}\n\
         kw.ssfk.kw_nr_max {points}\nkw.ssfk.bilateral 1\n",
        order.axis
    );
    let value = |name: &str, node: &Node| match name {
        "setpoint" => node.position,
        "pos" => -node.forward,
        _ => -node.backward,
    };
    for name in ["setpoint", "pos", "neg"] {
        for (i, node) in table.nodes.iter().enumerate() {
            // Whole numbers, so that nothing has no sign. Writing to a String does not fail.
            let _ = writeln!(text, "kw.ssfk.table[{i}].{name} {}", counts(value(name, node)) as i64);
        }
    }
    let notes = vec![
        "put the number of the axis into kopf.achs_nr, name the file in the start-up list, and set lr_param.ssfk 1 and no \
         backlash compensation, for the list holds the reversal"
            .into(),
    ];
    Ok(Written { files: vec![("beckhoff.lis", text)], table, notes })
}
