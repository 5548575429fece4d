//! FANUC Series 16i, 18i, 30i: bidirectional pitch error compensation, 3605#0 [FANUC, Technical Report A-77810E (2000)].
//!
//! As `fanuc`, with a second list of increments for the way back, whose first point has the number 3626; 3627 is what
//! is added at the reference point on the way back more than forwards, in detection units. The part of the report that
//! could be read names the parameters; that increments of the way back are counted towards larger positions as well,
//! and that 3627 is positive towards these, is taken, and told.

use std::fmt::Write;

use super::fanuc::{AS_PUNCHED, Numbers, RANGE, increments, tape};
use super::order::{Control, Order, Written, within};
use crate::positioning::Direction;

/// Most increments between the ends of the stroke.
const MOST: usize = 128;

/// Largest number of a point.
const LAST_NUMBER: i64 = 1023;

/// `--for fanuc-bidirectional`.
pub const FANUC_BIDIRECTIONAL: Control = Control {
    name: "fanuc-bidirectional",
    about: "FANUC 16i, 18i, 30i: pitch error increments for each direction, 3605#0",
    turns: false,
    write,
};

fn write(order: &Order) -> Result<Written, String> {
    let mut notes = Vec::new();
    let counted = order.counted(order.both, MOST + 1, &mut notes)?;
    let (steps, detection) = (counted.steps, counted.steps.detection_unit());
    let forward = counted.sums(Direction::Forward, steps.unit);
    let offset = (counted.at_reference() / detection).round();
    // On the way back the control counts from what 3627 makes it add at the reference point.
    let backward = counted.sums_from(Direction::Backward, offset * detection, steps.unit);
    let lists = [increments(&forward), increments(&backward)];
    for list in &lists {
        within(list, RANGE[0], RANGE[1], steps.magnification)?;
    }
    let numbers = Numbers::of(&counted, lists[0].len() as i64)?;
    let second = numbers.last + 1;
    if second + lists[1].len() as i64 - 1 > LAST_NUMBER {
        return Err(format!("both lists of points go beyond the number {LAST_NUMBER}: make `number` of `steps` less"));
    }
    let mut parameters = String::from("3605#0 1   a table for each direction\n");
    parameters.push_str(&numbers.parameters(&counted));
    // Writing to a String does not fail.
    let _ = writeln!(
        parameters,
        "3626 {second}   number of the first point for the way back\n3627 {offset:.0}   added at the reference point on the way \
         back, detection units\n1851 0   backlash, which the tables hold"
    );
    let metres = |sums: &[i64], from: f64| sums.iter().map(|sum| from + *sum as f64 * steps.unit).collect::<Vec<_>>();
    let table = counted.table(&metres(&forward, 0.0), &metres(&backward, offset * detection));
    notes.push(
        "enter fanuc-bidirectional-parameters.txt by hand, read in fanuc-bidirectional.txt, switch off and on, go to the \
         reference point"
            .into(),
    );
    notes.push(
        "increments of the way back and 3627 are taken as positive towards larger positions, as forwards: look at one \
         point from both sides first"
            .into(),
    );
    notes.push(AS_PUNCHED.into());
    let tape = tape(&[(numbers.first, &lists[0]), (second, &lists[1])]);
    let files = vec![("fanuc-bidirectional.txt", tape), ("fanuc-bidirectional-parameters.txt", parameters)];
    Ok(Written { files, table, notes })
}
