//! LinuxCNC: screw compensation, `COMP_FILE` with `COMP_FILE_TYPE = 0` [LinuxCNC, INI configuration, section JOINT].
//!
//! Lines of nominal, forward and reverse position in machine units (mm; deg where
//! the joint is ANGULAR), the last two being the positions that are
//! really reached; rising, without comments, at most 256, at any distances. `BACKLASH` of the joint is not used then.

use std::fmt::Write;

use super::order::{Control, Order, Written};

/// Name of the file.
pub const FILE: &str = "linuxcnc.comp";

/// Most lines that it takes for a joint.
const MOST: usize = 256;

/// `--for linuxcnc`.
pub const LINUXCNC: Control =
    Control { name: "linuxcnc", about: "LinuxCNC, COMP_FILE with COMP_FILE_TYPE = 0", turns: true, write };

fn write(order: &Order) -> Result<Written, String> {
    let mut notes = vec!["set COMP_FILE and COMP_FILE_TYPE = 0 of the joint; BACKLASH is not used then".into()];
    let table = order.whole(order.both, &mut notes);
    if table.nodes.len() > MOST {
        return Err(format!("{} targets are more than the {MOST} that it takes", table.nodes.len()));
    }
    let mut text = String::new();
    for node in &table.nodes {
        let [nominal, forward, reverse] =
            [node.position, node.position - node.forward, node.position - node.backward].map(|si| order.in_full(si));
        // Writing to a String does not fail.
        let _ = writeln!(text, "{nominal} {forward} {reverse}");
    }
    Ok(Written { files: vec![(FILE, text)], table, notes })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::positioning::{Law, Measures, Node, Table};

    #[test]
    fn it_is_told_where_the_axis_really_goes() {
        // 2 um are taken off where the axis goes 2 um too far.
        let node = |(mm, um): (f64, f64)| Node { position: 1e-3 * mm, forward: 1e-6 * um, backward: 1e-6 * (um - 3.0) };
        let table = Table { law: Law::Points, nodes: [(0.0, -2.0), (100.0, -4.0), (250.5, 1.0)].map(node).into() };
        let order = Order { axis: "X", one: &table, both: &table, steps: None, measures: Measures::LINEAR };
        let written = write(&order).unwrap();
        assert_eq!(
            written.files[0].1,
            "0.000000 0.002000 0.005000\n100.000000 100.004000 100.007000\n250.500000 250.499000 250.502000\n"
        );
        let long = Table { law: Law::Points, nodes: vec![table.nodes[0]; 257] };
        assert!(write(&Order { both: &long, ..order }).is_err_and(|why| why.contains("256")));
    }
}
