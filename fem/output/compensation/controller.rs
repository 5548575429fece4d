//! Writes tables in general form; files of single controls are in `control`.
//!
//! A value that is *added* goes onto the commanded position; it is the deviation with the other sign.

use crate::compensate::{Compensation, Course};
use crate::positioning::{Direction, Measures, Steps, Table as Entries};
use crate::process::{Column, Table, Words};

/// A column of deviations.
fn off(name: &'static str, measures: Measures, values: impl Iterator<Item = f64>) -> Column {
    // Rounded to a thousandth of a nanometre, or a millionth of a second of arc: smaller digits are round-off of sums.
    // Nothing has no sign.
    let values = values.map(|si| (measures.off(si) * 1e6).round() / 1e6 + 0.0).collect();
    Column::numbers(name, Some(measures.deviation_unit()), values)
}

/// A column of positions.
fn places(name: &'static str, measures: Measures, values: impl Iterator<Item = f64>) -> Column {
    let values = values.map(|si| measures.place(si)).collect();
    Column::numbers(name, Some(measures.position_unit()), values)
}

/// Name of the column of commanded positions.
fn commanded(measures: Measures) -> &'static str {
    if measures.is_rotary() { "angle" } else { "position" }
}

/// Makes one row a point: the value added there, linear from point to point, and its increment over the
/// point before.
pub fn points(table: &Entries, measures: Measures) -> Table {
    let added: Vec<f64> = table.nodes.iter().map(|n| n.forward).collect();
    let steps = std::iter::once(0.0).chain(added.windows(2).map(|w| w[1] - w[0]));
    Table {
        columns: vec![
            places(commanded(measures), measures, table.nodes.iter().map(|n| n.position)),
            off("added", measures, added.iter().copied()),
            off("increment", measures, steps),
            off("backlash", measures, table.nodes.iter().map(|n| n.forward - n.backward)),
        ],
    }
}

/// Makes one row a segment, from midway to midway between the targets, with the value added all along it.
pub fn segments(table: &Entries, measures: Measures) -> Table {
    let targets: Vec<f64> = table.nodes.iter().map(|n| n.position).collect();
    let middles: Vec<f64> = targets.windows(2).map(|w| 0.5 * (w[0] + w[1])).collect();
    let from = targets.first().copied().into_iter().chain(middles.iter().copied());
    let to = middles.iter().copied().chain(targets.last().copied());
    Table {
        columns: vec![
            places("from", measures, from),
            places("to", measures, to),
            off("added", measures, table.nodes.iter().map(|n| n.forward)),
            off("backlash", measures, table.nodes.iter().map(|n| n.forward - n.backward)),
        ],
    }
}

/// Makes one row a point, with the value added in each direction.
pub fn both_directions(table: &Entries, measures: Measures) -> Table {
    Table {
        columns: vec![
            places(commanded(measures), measures, table.nodes.iter().map(|n| n.position)),
            off("added_forward", measures, table.nodes.iter().map(|n| n.forward)),
            off("added_backward", measures, table.nodes.iter().map(|n| n.backward)),
        ],
    }
}

/// Makes one row a point at which the controller takes an increment, counted from its reference point.
pub fn increments(table: &Entries, steps: Steps, measures: Measures) -> Table {
    let steps = table.increments(steps);
    let counts: Option<Vec<f64>> = steps.iter().map(|s| s.counts.map(|count| count as f64)).collect();
    let counts = counts.map(|counts| Column::numbers("counts", None, counts));
    let columns = [
        Column::numbers("number", None, steps.iter().map(|s| s.number as f64).collect()),
        places(commanded(measures), measures, steps.iter().map(|s| s.position)),
        off("from_reference", measures, steps.iter().map(|s| s.from_reference)),
        off("increment", measures, steps.iter().map(|s| s.increment)),
    ];
    Table { columns: columns.into_iter().chain(counts).collect() }
}

/// Makes the table of the modelled axis along its travel, before and after.
pub fn predicted(compensation: &Compensation) -> Table {
    let [points, segments, both] = &compensation.schemes;
    let (course, measures) = (&points.modelled, compensation.measures);
    let before = points.table.removed(&course.approaches, &course.deviations);
    let after = |name: &'static str, course: &Course| off(name, measures, course.deviations.iter().copied());
    let backward = |a: &crate::positioning::Approach| f64::from(u8::from(a.direction == Direction::Backward));
    Table {
        columns: vec![
            places(commanded(measures), measures, course.approaches.iter().map(|a| a.position)),
            Column::words("direction", course.approaches.iter().map(backward).collect(), Words::Known(&["+", "-"])),
            off("deviation", measures, before.into_iter()),
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
        let points = lines(&points(&table(Law::Points), Measures::LINEAR));
        assert_eq!(
            points,
            ["position [mm],added [um],increment [um],backlash [um]", "0,-2,0,3", "100,-4,-2,3", "250.5,1,5,3"]
        );
        let segments = lines(&segments(&table(Law::Segments), Measures::LINEAR));
        assert_eq!(segments[1..], ["0,50,-2,3", "50,175.25,-4,3", "175.25,250.5,1,3"]);
        assert_eq!(
            lines(&both_directions(&table(Law::Points), Measures::LINEAR))[1..],
            ["0,-2,-5", "100,-4,-7", "250.5,1,-2"]
        );
    }
}
