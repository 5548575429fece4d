//! Tables of angles, and what they leave.

use super::rig::*;
use crate::positioning::Direction::{Backward, Forward};
use crate::positioning::{Direction, Law, Node, Reversal, Table};
use crate::validation::Case;

/// Means forwards and backwards at 0, 90, 180, 270 degrees (arcsec).
const MEANS: [(f64, f64, f64); 4] = [(0.0, 0.0, 20.0), (90.0, 8.0, 30.0), (180.0, 2.0, 20.0), (270.0, -6.0, 18.0)];

pub fn cases() -> Vec<Case> {
    let test = test(MEANS.into_iter().flat_map(|(at, there, back)| [(at, Forward, there), (at, Backward, back)]));
    let reversal = Reversal::of(&test);
    let points = Table::with_backlash(&test, Law::Points, 0.0);
    let whole = Table::both_directions(&test, Law::Points, 0.0);
    let arcsec = |name: &str, quantity, expected: f64, si: Option<f64>| {
        let computed = si.map_or(f64::NAN, |si| ARCSEC * si);
        row(name, quantity, (expected, computed, "arcsec"), ROUND_OFF, "seed 001 with angles, by hand")
    };
    let left = |table: &Table, i: usize, direction: Direction| {
        let target = test.targets.get(i)?;
        Some(target.side(direction)?.mean + table.correction(target.position, direction))
    };
    let added = |table: &Table, angle: f64| Some(table.correction(angle.to_radians(), Forward));
    let closes = |node: Option<&Node>| node.map(|node| node.forward);
    vec![
        // Lost motion of 20, 22, 18 and 24.
        arcsec("four targets of a turn", "backlash value", 21.0, reversal.as_ref().map(|r| r.value)),
        arcsec("four targets of a turn", "rest of the reversal", 3.0, reversal.as_ref().map(|r| r.rest)),
        // Means of forwards and backwards less 21: -0.5, 8.5, 0.5, -4.5.
        arcsec("table of angles, at the first target", "added", 0.5, closes(points.nodes.first())),
        arcsec("table of angles, midway between 90 and 180 deg", "added", -4.5, added(&points, 135.0)),
        arcsec("table of angles, at 270 deg forwards", "left", -1.5, left(&points, 3, Forward)),
        arcsec("table of angles, at 270 deg backwards", "left", 1.5, left(&points, 3, Backward)),
        arcsec("table each way, at 270 deg backwards", "left", 0.0, left(&whole, 3, Backward)),
    ]
}
