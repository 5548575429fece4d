//! FANUC Series 0i, 16i, 18i, 30i: stored pitch error compensation with a backlash value [FANUC Series 0i Parameter
//! Manual, B-63980EN, parameters 3620 to 3624; tape of parameters and pitch errors: Series 15i Parameter Manual,
//! B-63330EN, 3].
//!
//! A whole number at each point: what is added from the point before to it, in the direction of larger positions, in
//! counts of detection unit times magnification (3623). Points stand at equal distances (3624); their numbers are
//! counted from that of the reference point (3620), at which nothing is added: a point n stands for the way from n − 1
//! to n, so that the stroke begins at the point after its end (3621), as in the example of the manual, p. 100. The sums
//! of the numbers are the rounded table, so that roundings do not add up. Between two points the control adds its
//! counts somewhere; at the points it has added them.
//!
//! The limits (−7 to 7, 128 between the ends of the stroke, numbers 0 to 1023) and the words of the tape (N10000 and the
//! number of the point) are those of guides to these controls; the pages of the manuals that could be read have the
//! form `N…P…;` between `%` alone, which is told.

use std::fmt::Write;

use super::order::{Control, Counted, Order, Written, within};
use crate::output::number::mm;
use crate::positioning::Direction;

/// Most increments between the ends of the stroke.
const MOST: usize = 128;

/// Least and largest increment.
pub(super) const RANGE: [i64; 2] = [-7, 7];

/// Largest number of a point.
const LAST_NUMBER: i64 = 1023;

/// Offset from the number of a point to the number of its word on a tape.
const TAPE: i64 = 10_000;

/// Note for the user: a check before a tape is read in.
pub(super) const AS_PUNCHED: &str =
    "the tape numbers the points from N10000 on: compare it with what the control itself punches out first";

/// `--for fanuc`.
pub const FANUC: Control = Control {
    name: "fanuc",
    about: "FANUC 0i, 16i, 18i, 30i: pitch error increments and a backlash value",
    turns: false,
    write,
};

fn write(order: &Order) -> Result<Written, String> {
    let mut notes = Vec::new();
    let counted = order.counted(order.one, MOST + 1, &mut notes)?;
    let steps = counted.steps;
    let sums = counted.sums(Direction::Forward, steps.unit);
    let increments = increments(&sums);
    within(&increments, RANGE[0], RANGE[1], steps.magnification)?;
    let numbers = Numbers::of(&counted, increments.len() as i64)?;
    let backlash = counted.backlash(steps.detection_unit());
    let mut parameters = String::from("3605#0 0   one table for both directions\n");
    parameters.push_str(&numbers.parameters(&counted));
    // Writing to a String does not fail.
    let _ = writeln!(parameters, "1851 {backlash}   backlash, detection units");
    let forward: Vec<f64> = sums.iter().map(|sum| *sum as f64 * steps.unit).collect();
    let backward: Vec<f64> = forward.iter().map(|added| added - backlash as f64 * steps.detection_unit()).collect();
    notes.push(
        "enter fanuc-parameters.txt by hand, read in fanuc.txt, switch off and on, go to the reference point".into(),
    );
    notes.push(AS_PUNCHED.into());
    let files = vec![("fanuc.txt", tape(&[(numbers.first, &increments)])), ("fanuc-parameters.txt", parameters)];
    Ok(Written { files, table: counted.table(&forward, &backward), notes })
}

/// Increments from each point to the next, in counts.
pub(super) fn increments(sums: &[i64]) -> Vec<i64> {
    sums.windows(2).map(|pair| pair[1] - pair[0]).collect()
}

/// Numbers that the control gives to points.
pub(super) struct Numbers {
    /// Of the reference point, 3620.
    pub reference: i64,
    /// Of the first that holds an increment, 3621.
    pub first: i64,
    /// Of the last, 3622.
    pub last: i64,
}

impl Numbers {
    /// The numbers of the points behind the first of a table: as the model says, or from 0 on.
    pub fn of(counted: &Counted, increments: i64) -> Result<Self, String> {
        let reference = counted.steps.number.unwrap_or((-counted.first - 1).max(0));
        let first = reference + counted.first + 1;
        let last = first + increments - 1;
        if first < 0 || last > LAST_NUMBER {
            return Err(format!(
                "the points would have the numbers {first} to {last}, and it has 0 to {LAST_NUMBER}: change `number` of \
                 `steps`, which is that of the reference point"
            ));
        }
        Ok(Self { reference, first, last })
    }

    /// The parameters that place the points, a line each.
    pub fn parameters(&self, counted: &Counted) -> String {
        let steps = counted.steps;
        format!(
            "3620 {}   number of the reference point, at {} mm\n3621 {}   number of the first point\n3622 {}   number of the \
             last point\n3623 {}   magnification\n3624 {}   distance of the points, mm\n",
            self.reference,
            mm(steps.reference, 6),
            self.first,
            self.last,
            steps.magnification,
            mm(steps.interval, 6)
        )
    }
}

/// The tape: increments, each list from the number of its first point on.
pub(super) fn tape(lists: &[(i64, &[i64])]) -> String {
    let mut text = String::from("%\n");
    for (first, increments) in lists {
        for (number, increment) in (TAPE + first..).zip(increments.iter()) {
            // Writing to a String does not fail.
            let _ = writeln!(text, "N{number}P{increment};");
        }
    }
    text.push_str("%\n");
    text
}
