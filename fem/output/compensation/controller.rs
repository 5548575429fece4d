//! Writes tables in general form; files of single controls are in `control`.
//!
//! A value that is *added* goes onto the commanded position; it is the deviation with the other sign.

use crate::compensate::{Compensation, Course};
use crate::positioning::{Direction, Steps, Table as Entries};
use crate::process::{Column, Table, Words};

fn um(values: impl Iterator<Item = f64>) -> Vec<f64> {
    // Rounded to a thousandth of a nanometre: smaller digits are round-off of sums. Nothing has no sign.
    values.map(|m| (m * 1e12).round() / 1e6 + 0.0).collect()
}

fn mm(values: impl Iterator<Item = f64>) -> Vec<f64> {
    values.map(|m| (m * 1e12).round() / 1e9 + 0.0).collect()
}

/// Makes one row a point: the value added there, linear from point to point, and its increment over the
/// point before.
pub fn points(table: &Entries) -> Table {
    let added: Vec<f64> = table.nodes.iter().map(|n| n.forward).collect();
    let steps = std::iter::once(0.0).chain(added.windows(2).map(|w| w[1] - w[0]));
    Table {
        columns: vec![
            Column::numbers("position", Some("mm"), mm(table.nodes.iter().map(|n| n.position))),
            Column::numbers("added", Some("um"), um(added.iter().copied())),
            Column::numbers("increment", Some("um"), um(steps)),
            Column::numbers("backlash", Some("um"), um(table.nodes.iter().map(|n| n.forward - n.backward))),
        ],
    }
}

/// Makes one row a segment, from midway to midway between the targets, with the value added all along it.
pub fn segments(table: &Entries) -> Table {
    let places: Vec<f64> = table.nodes.iter().map(|n| n.position).collect();
    let middles: Vec<f64> = places.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
    let from = places.first().copied().into_iter().chain(middles.iter().copied());
    let to = middles.iter().copied().chain(places.last().copied());
    Table {
        columns: vec![
            Column::numbers("from", Some("mm"), mm(from)),
            Column::numbers("to", Some("mm"), mm(to)),
            Column::numbers("added", Some("um"), um(table.nodes.iter().map(|n| n.forward))),
            Column::numbers("backlash", Some("um"), um(table.nodes.iter().map(|n| n.forward - n.backward))),
        ],
    }
}

/// Makes one row a point, with the value added in each direction.
pub fn both_directions(table: &Entries) -> Table {
    Table {
        columns: vec![
            Column::numbers("position", Some("mm"), mm(table.nodes.iter().map(|n| n.position))),
            Column::numbers("added_forward", Some("um"), um(table.nodes.iter().map(|n| n.forward))),
            Column::numbers("added_backward", Some("um"), um(table.nodes.iter().map(|n| n.backward))),
        ],
    }
}

/// Makes one row a point at which the controller takes an increment, counted from its reference point.
pub fn increments(table: &Entries, steps: Steps) -> Table {
    let steps = table.increments(steps);
    let counts: Option<Vec<f64>> = steps.iter().map(|s| s.counts.map(|count| count as f64)).collect();
    let counts = counts.map(|counts| Column::numbers("counts", None, counts));
    let columns = [
        Column::numbers("number", None, steps.iter().map(|s| s.number as f64).collect()),
        Column::numbers("position", Some("mm"), mm(steps.iter().map(|s| s.position))),
        Column::numbers("from_reference", Some("um"), um(steps.iter().map(|s| s.from_reference))),
        Column::numbers("increment", Some("um"), um(steps.iter().map(|s| s.increment))),
    ];
    Table { columns: columns.into_iter().chain(counts).collect() }
}

/// Makes the table of the modelled axis along its travel, before and after.
pub fn predicted(compensation: &Compensation) -> Table {
    let [points, segments, both] = &compensation.schemes;
    let course = &points.modelled;
    let before = points.table.removed(&course.approaches, &course.deviations);
    let after = |name, course: &Course| Column::numbers(name, Some("um"), um(course.deviations.iter().copied()));
    let backward = |a: &crate::positioning::Approach| f64::from(u8::from(a.direction == Direction::Backward));
    Table {
        columns: vec![
            Column::numbers("position", Some("mm"), mm(course.approaches.iter().map(|a| a.position))),
            Column::words("direction", course.approaches.iter().map(backward).collect(), Words::Known(&["+", "-"])),
            Column::numbers("deviation", Some("um"), um(before.into_iter())),
            after("with_points", &points.modelled),
            after("with_segments", &segments.modelled),
            after("with_both_directions", &both.modelled),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::positioning::{Law, Node};

    /// Adds −2, −4 and 1 um, and 3 um less on the way back.
    fn table(law: Law) -> Entries {
        let node = |(mm, um): (f64, f64)| Node { position: 1e-3 * mm, forward: 1e-6 * um, backward: 1e-6 * (um - 3.0) };
        Entries { law, nodes: [(0.0, -2.0), (100.0, -4.0), (250.5, 1.0)].map(node).into() }
    }

    fn lines(table: &Table) -> Vec<String> {
        super::super::csv::table(table).lines().map(str::to_string).collect()
    }

    #[test]
    fn tables_say_what_is_added() {
        let points = lines(&points(&table(Law::Points)));
        assert_eq!(
            points,
            ["position [mm],added [um],increment [um],backlash [um]", "0,-2,0,3", "100,-4,-2,3", "250.5,1,5,3"]
        );
        let segments = lines(&segments(&table(Law::Segments)));
        assert_eq!(segments[1..], ["0,50,-2,3", "50,175.25,-4,3", "175.25,250.5,1,3"]);
        assert_eq!(lines(&both_directions(&table(Law::Points)))[1..], ["0,-2,-5", "100,-4,-7", "250.5,1,-2"]);
    }
}
