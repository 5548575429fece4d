//! The wear land at the end of the batch, and the path that is left until it is as wide as it may be.

use super::super::edge::Edge;
use super::super::machine::Machine;
use crate::process::{Datum, Figure};
use crate::units::{LENGTH, PATH};

/// Paths beyond this one are not looked at, m.
const FARTHEST: f64 = 1e7;

/// The figure of a model that tells of its edge, and a warning where the edge is not good for the batch. The land is
/// what belongs to the draw-back of all effects that wear the edge: h = U/tan α [seed 002 (31)].
pub fn figure(machine: &Machine) -> Option<(Figure, Option<String>)> {
    let edge = machine.setup.edge.as_ref().filter(|_| !machine.wears.is_empty())?;
    let schedule = &machine.setup.schedule;
    let end = schedule.path(schedule.parts, schedule.pass.to);
    let land = machine.wear(end) / edge.clearance;
    let told = format!("{:.3} wide after the batch, {:.1} of cutting path", LENGTH.shown(land), PATH.shown(end));
    let figure = Figure::new("wear_land", "wear land").unit("path_unit", PATH);
    let figure = figure.quantity("width", LENGTH, land).quantity("path", PATH, end).line(told);
    let Some(largest) = edge.largest_land else { return Some((figure, None)) };
    let life = life(machine, edge, largest);
    let limit = LENGTH.format(largest);
    let (line, warning) = match life {
        Some(path) if path < schedule.longest_path() => {
            let part = (1..=schedule.parts).find(|k| schedule.path(*k, schedule.pass.to) >= path).unwrap_or(1);
            let line = format!("{limit} is reached after {:.1}, on part {part}", PATH.shown(path));
            let warning = format!("the wear land is wider than {limit} from part {part} on: change the edge before it");
            (line, Some(warning))
        }
        Some(path) => {
            let each = schedule.path(1, schedule.pass.to);
            let (left, parts) = (PATH.shown(path - end), ((path - end) / each) as usize);
            (format!("{limit} is reached after {:.1}: {left:.1} more, or {parts} parts", PATH.shown(path)), None)
        }
        None => (format!("{limit} is not reached as far as the wear is known"), None),
    };
    let figure = figure.quantity("largest", LENGTH, largest).entry("life", Datum::maybe(PATH, life));
    Some((figure.entry("left", Datum::maybe(PATH, life.map(|path| path - end))).line(line), warning))
}

/// Path at which the land is as wide as it may be, m; `None` where it never is.
fn life(machine: &Machine, edge: &Edge, largest: f64) -> Option<f64> {
    let is_worn = |path: f64| machine.wear(path) >= largest * edge.clearance;
    let mut high = 1.0;
    while !is_worn(high) {
        high *= 2.0;
        if high > FARTHEST {
            return None;
        }
    }
    let mut low = 0.0;
    while high - low > 1e-12 * high {
        let middle = 0.5 * (low + high);
        if is_worn(middle) { high = middle } else { low = middle }
    }
    Some(high)
}
