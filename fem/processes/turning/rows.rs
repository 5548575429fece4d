//! Diameters as they are measured: where on which part, and under which conditions the row was cut.

use super::cut::Conditions;
use super::setup::Setup;
use crate::process::{Absent, Coordinate, Holds, Misplaced, Observable, Places, RADIUS_CHANGE, Rows, Values};
use crate::units::{FEED, FORCE, LENGTH, MICRO, PATH, SPINDLE_SPEED, TIME};

/// No part is as far off, m.
const FAR_OFF: f64 = 5e-3;

/// A diameter is the set diameter plus its error.
pub const OBSERVABLES: &[Observable] = &[
    Observable::within("diameter_error", "the diameter", MICRO, FAR_OFF),
    Observable::within("diameter", "the diameter", LENGTH, FAR_OFF),
];
/// Position of the whole diameter in [`OBSERVABLES`].
pub const DIAMETER: usize = 1;

/// Positions in [`COORDINATES`]: the distance from the headstock.
pub const X: usize = 0;
/// The number of the part.
pub const PART: usize = 1;
/// The nominal radial force.
pub const FORCE_OF_ROW: usize = 2;
const DEPTH: usize = 3;
const FEED_OF_ROW: usize = 4;
const SPEED_OF_ROW: usize = 5;
/// The diameter before the cut.
pub const BLANK: usize = 6;
/// The time since the batch began.
pub const TIME_OF_ROW: usize = 7;
/// The cutting path of the tool so far.
pub const PATH_OF_ROW: usize = 8;

/// The angle around the part.
pub const ANGLE: usize = 9;
/// What the last pass was programmed to beside the radius that is meant.
pub const CHANGE: usize = 10;

/// Force, depth, feed and speed of a row act on its own force only; the schedule stays the model's, but for
/// a row's own time and path.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new("x", "distance from the headstock", Holds::Quantity(LENGTH), Absent::Refused),
    Coordinate::new("part", "number of the part", Holds::Number(1), Absent::Value(1.0)),
    Coordinate::new("radial_force", "nominal radial force", Holds::Quantity(FORCE), Absent::Model),
    Coordinate::new("depth", "set depth of cut", Holds::Quantity(LENGTH), Absent::Model),
    Coordinate::new("feed", "feed per revolution", Holds::Quantity(FEED), Absent::Model),
    Coordinate::new("spindle_speed", "spindle speed", Holds::Quantity(SPINDLE_SPEED), Absent::Model),
    Coordinate::new("blank", "diameter before the cut", Holds::Quantity(LENGTH), Absent::Model),
    Coordinate::new("time", "time since the batch began", Holds::Quantity(TIME), Absent::Model),
    Coordinate::new("path", "cutting path of the tool so far", Holds::Quantity(PATH), Absent::Model),
    Coordinate::new(
        "angle",
        "angle around the part, from its mark",
        Holds::Quantity(crate::units::ANGLE),
        Absent::Value(0.0),
    ),
    Coordinate::new(
        RADIUS_CHANGE,
        "what was added to the programmed radius",
        Holds::Quantity(LENGTH),
        Absent::Value(0.0),
    ),
];

/// Rows off the shaft, beyond the batch, or cut with what no cut can have.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let (length, parts) = (setup.length(), setup.schedule.parts);
    let check = |row: usize| {
        let value = |column| rows.get(column, row);
        let wrong = |coordinate, message: String| Some(Misplaced { row, coordinate, message });
        // A length that is to be fitted bounds nothing yet.
        let is_off = |x: &f64| length.is_finite() && !(-1e-9 * length..=length * (1.0 + 1e-9)).contains(x);
        if let Some(x) = value(X).filter(is_off) {
            let [x, end] = [x, length].map(|x| LENGTH.format(x));
            return wrong(X, format!("x = {x} is not on the shaft, which reaches from 0 to {end}"));
        }
        if let Some(part) = value(PART).filter(|p| *p > parts as f64) {
            return wrong(PART, format!("part {part} is beyond the batch of {parts}"));
        }
        for column in [FORCE_OF_ROW, TIME_OF_ROW, PATH_OF_ROW] {
            if value(column).is_some_and(|v| v < 0.0) {
                return wrong(column, format!("`{}` is below zero", COORDINATES[column].name));
            }
        }
        for column in [DEPTH, FEED_OF_ROW, BLANK] {
            if value(column).is_some_and(|v| v <= 0.0) {
                return wrong(column, format!("`{}` is not above zero", COORDINATES[column].name));
            }
        }
        None
    };
    (0..rows.len()).filter_map(check).collect()
}

/// The model's own programme: part by part, x rising.
pub fn programme(setup: &Setup) -> Rows {
    let (sweep, parts) = (setup.sweep(), setup.schedule.parts);
    let mut columns = vec![Values::shared(f64::NAN, sweep.len()); COORDINATES.len()];
    columns[X] = sweep.clone().into();
    [ANGLE, CHANGE].into_iter().for_each(|column| columns[column].fill(0.0));
    let first = resolved(setup, &Rows { columns, observable: Values::shared(0, sweep.len()) });
    // Parts differ in their number, and in time and path.
    let each = |of: &dyn Fn(usize, f64) -> f64| {
        (1..=parts).flat_map(|part| sweep.iter().map(move |x| of(part, *x))).collect::<Values>()
    };
    let column = |(column, values): (usize, &Values)| match column {
        PART => each(&|part, _| part as f64),
        TIME_OF_ROW => each(&|part, x| setup.schedule.time(part, x)),
        PATH_OF_ROW => each(&|part, x| setup.schedule.path(part, x)),
        _ => (0..parts).flat_map(|_| values.iter().copied()).collect(),
    };
    let columns = first.columns.iter().enumerate().map(column).collect();
    Rows { columns, observable: Values::shared(0, parts * sweep.len()) }
}

/// The coordinates that the model can fill in.
const FILLED: [usize; 8] = [PART, FORCE_OF_ROW, DEPTH, FEED_OF_ROW, SPEED_OF_ROW, BLANK, TIME_OF_ROW, PATH_OF_ROW];

/// Every coordinate of every row, those left to the model filled in.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let pass = setup.schedule.pass;
    let mut filled = FILLED.map(|_| Values::with_capacity(rows.len()));
    for row in 0..rows.len() {
        let (part, x) = (part(rows, row), rows.get(X, row).unwrap_or(0.0));
        let diameter = setup.diameter(x);
        let conditions = conditions(setup, rows, row, diameter);
        let (time, path) = moment(setup, rows, row, part, x);
        let own = [
            part as f64,
            conditions.force,
            rows.get(DEPTH, row).unwrap_or(setup.cut.depth),
            rows.get(FEED_OF_ROW, row).unwrap_or(pass.feed),
            rows.get(SPEED_OF_ROW, row).unwrap_or(pass.spindle_speed),
            rows.get(BLANK, row).unwrap_or(diameter + 2.0 * conditions.set_depth),
            time,
            path,
        ];
        filled.iter_mut().zip(own).for_each(|(column, value)| column.push(value));
    }
    let mut all = rows.clone();
    FILLED.into_iter().zip(filled).for_each(|(column, values)| all.columns[column] = values);
    all
}

/// The number of the part of a row.
pub fn part(rows: &Rows, row: usize) -> usize {
    rows.get(PART, row).unwrap_or(1.0) as usize
}

/// Time (s) and cutting path (m) of a row at `x` on `part`: its own, or by the schedule.
pub fn moment(setup: &Setup, rows: &Rows, row: usize, part: usize, x: f64) -> (f64, f64) {
    let time = rows.get(TIME_OF_ROW, row).unwrap_or_else(|| setup.schedule.time(part, x));
    (time, rows.get(PATH_OF_ROW, row).unwrap_or_else(|| setup.schedule.path(part, x)))
}

/// On the axis, part by part; a diameter grows to either side, and half of it is shown.
pub fn places(setup: &Setup, rows: &Rows) -> Places {
    let x = |row| rows.get(X, row).unwrap_or(0.0);
    let reference = |row: usize| if rows.observable[row] == DIAMETER { setup.diameter(x(row)) } else { 0.0 };
    Places {
        points: (0..rows.len()).map(|row| [x(row), 0.0, 0.0]).collect(),
        directions: vec![[0.0, 0.5, 0.0]; rows.len()],
        along: (0..rows.len()).map(x).collect(),
        references: (0..rows.len()).map(reference).collect(),
        frames: (0..rows.len()).map(|row| part(rows, row) as f64).collect(),
    }
}

/// Force and depth of a row. P₀ is the row's force, or by the force law at its depth and feed, or the
/// model's. The set depth follows from the blank, or is the row's or the model's. With feedback P₀ belongs
/// to the model's own depth, from which the feedback takes it to the depth really cut.
pub fn conditions(setup: &Setup, rows: &Rows, row: usize, diameter: f64) -> Conditions {
    let depth = rows.get(DEPTH, row).unwrap_or(setup.cut.depth);
    let set_depth = rows.get(BLANK, row).map_or(depth, |blank| 0.5 * (blank - diameter));
    let feed = rows.get(FEED_OF_ROW, row).unwrap_or(setup.schedule.pass.feed);
    let nominal = |depth: f64| setup.cut.force.at(rows.get(X, row).unwrap_or(0.0), depth, feed);
    let given = rows.get(FORCE_OF_ROW, row);
    Conditions {
        force: given.unwrap_or_else(|| nominal(depth)),
        nominal: given.unwrap_or_else(|| nominal(setup.cut.depth)),
        nominal_depth: setup.cut.depth,
        set_depth,
    }
}
