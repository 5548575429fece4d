//! Diameters as they are measured: where on which part, and under which conditions the row was cut.

use rayon::prelude::*;

use super::cut::Force;
use super::elastic::{Conditions, Elastic};
use super::lathe::Lathe;
use super::machine::Moment;
use super::model::Setup;
use crate::process::{Absent, Coordinate, Failure, Holds, Misplaced, Observable, Places, Rows};
use crate::units::{FEED, FORCE, LENGTH, MICRO, PATH, SPINDLE_SPEED, TIME};

/// A diameter is the set diameter plus its error.
pub const OBSERVABLES: &[Observable] = &[
    Observable { name: "diameter_error", words: "the diameter", kind: MICRO },
    Observable { name: "diameter", words: "the diameter", kind: LENGTH },
];
const DIAMETER: usize = 1;

/// Positions in [`COORDINATES`].
pub const X: usize = 0;
pub const PART: usize = 1;
pub const FORCE_OF_ROW: usize = 2;
const DEPTH: usize = 3;
const FEED_OF_ROW: usize = 4;
const SPEED_OF_ROW: usize = 5;
pub const BLANK: usize = 6;
pub const TIME_OF_ROW: usize = 7;
pub const PATH_OF_ROW: usize = 8;

/// A row's force, depth, feed and speed act on its own force only; the schedule stays the model's, but for a row's own time and path.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate { absent: Absent::Refused, ..coordinate("x", "distance from the headstock", Holds::Quantity(LENGTH)) },
    Coordinate { absent: Absent::Value(1.0), ..coordinate("part", "number of the part", Holds::Number(1)) },
    coordinate("radial_force", "nominal radial force", Holds::Quantity(FORCE)),
    coordinate("depth", "set depth of cut", Holds::Quantity(LENGTH)),
    coordinate("feed", "feed per revolution", Holds::Quantity(FEED)),
    coordinate("spindle_speed", "spindle speed", Holds::Quantity(SPINDLE_SPEED)),
    coordinate("blank", "diameter before the cut", Holds::Quantity(LENGTH)),
    coordinate("time", "time since the batch began", Holds::Quantity(TIME)),
    coordinate("path", "cutting path of the tool so far", Holds::Quantity(PATH)),
];

const fn coordinate(name: &'static str, about: &'static str, holds: Holds) -> Coordinate {
    Coordinate { name, about, holds, absent: Absent::Model, repeats: false }
}

/// Rows off the shaft, beyond the batch, or cut with what no cut can have.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let (length, parts) = (setup.length(), setup.schedule.parts);
    let check = |row: usize| {
        let value = |column| rows.get(column, row);
        // A length that is to be fitted bounds nothing yet.
        let wrong = |coordinate, message: String| Some(Misplaced { row, coordinate, message });
        if let Some(x) =
            value(X).filter(|x| length.is_finite() && !(-1e-9 * length..=length * (1.0 + 1e-9)).contains(x))
        {
            return wrong(
                X,
                format!("x = {} mm is not on the shaft, which reaches from 0 to {} mm", 1e3 * x, 1e3 * length),
            );
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

/// What every row shows, m.
pub fn observe(lathe: &Lathe, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let setup = &*lathe.machine.setup;
    let length = setup.length();
    let at = |row: usize| rows.get(X, row).unwrap_or(0.0).clamp(0.0, length);
    let mut positions: Vec<f64> = (0..rows.len()).map(at).collect();
    positions.sort_unstable_by(f64::total_cmp);
    positions.dedup();
    let shaft = lathe.condense(&positions)?;
    let elastic = Elastic::new(&lathe.machine, &shaft);
    let one = |row: usize| {
        let x = at(row);
        let diameter = setup.diameter(x);
        let i = positions.partition_point(|p| *p < x);
        let mut at_row = conditions(setup, rows, row, diameter);
        if rows.get(BLANK, row).is_none() {
            at_row.set_depth += 0.5 * elastic.before(i, x).map_err(Failure::from)?;
        }
        let deflection = elastic.deflect(i, at_row).map_err(Failure::from)?;
        let part = rows.get(PART, row).unwrap_or(1.0) as usize;
        let moment = Moment {
            x,
            diameter,
            time: rows.get(TIME_OF_ROW, row).unwrap_or_else(|| setup.schedule.time(part, x)),
            path: rows.get(PATH_OF_ROW, row).unwrap_or_else(|| setup.schedule.path(part, x)),
        };
        let set = if rows.observable[row] == DIAMETER { diameter } else { 0.0 };
        Ok(set + 2.0 * deflection.total + lathe.shift_at(&moment))
    };
    (0..rows.len()).into_par_iter().with_min_len(256).map(one).collect()
}

/// The model's own programme: part by part, x rising.
pub fn programme(setup: &Setup) -> Rows {
    let sweep = setup.sweep();
    let parts = setup.schedule.parts;
    let count = parts * sweep.len();
    let mut columns = vec![vec![f64::NAN; count]; COORDINATES.len()];
    columns[X] = (0..parts).flat_map(|_| sweep.iter().copied()).collect();
    columns[PART] = (1..=parts).flat_map(|k| std::iter::repeat_n(k as f64, sweep.len())).collect();
    resolved(setup, &Rows { columns, observable: vec![0; count] })
}

/// Every coordinate of every row, those left to the model filled in.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let mut all = rows.clone();
    for row in 0..rows.len() {
        let x = rows.get(X, row).unwrap_or(0.0);
        let part = rows.get(PART, row).unwrap_or(1.0);
        let conditions = conditions(setup, rows, row, setup.diameter(x));
        let pass = setup.schedule.pass;
        let filled = [
            (X, x),
            (PART, part),
            (FORCE_OF_ROW, conditions.force),
            (DEPTH, rows.get(DEPTH, row).unwrap_or(setup.cut.depth)),
            (FEED_OF_ROW, rows.get(FEED_OF_ROW, row).unwrap_or(pass.feed)),
            (SPEED_OF_ROW, rows.get(SPEED_OF_ROW, row).unwrap_or(pass.spindle_speed)),
            (BLANK, rows.get(BLANK, row).unwrap_or(setup.diameter(x) + 2.0 * conditions.set_depth)),
            (TIME_OF_ROW, rows.get(TIME_OF_ROW, row).unwrap_or_else(|| setup.schedule.time(part as usize, x))),
            (PATH_OF_ROW, rows.get(PATH_OF_ROW, row).unwrap_or_else(|| setup.schedule.path(part as usize, x))),
        ];
        filled.iter().for_each(|(column, value)| all.columns[*column][row] = *value);
    }
    all
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
        frames: (0..rows.len()).map(|row| rows.get(PART, row).unwrap_or(1.0)).collect(),
    }
}

/// P₀ is the row's force, or by the force law at its depth and feed, or the model's. The set depth follows from the blank, or is
/// the row's or the model's. With feedback P₀ belongs to the model's own depth, from which the feedback takes it to the depth really cut.
fn conditions(setup: &Setup, rows: &Rows, row: usize, diameter: f64) -> Conditions {
    let depth = rows.get(DEPTH, row).unwrap_or(setup.cut.depth);
    let set_depth = rows.get(BLANK, row).map_or(depth, |blank| 0.5 * (blank - diameter));
    let feed = rows.get(FEED_OF_ROW, row).unwrap_or(setup.schedule.pass.feed);
    let nominal = |depth: f64| match setup.cut.force {
        Force::Given(force) => force,
        Force::Law(law) => law.force(depth, feed),
    };
    let given = rows.get(FORCE_OF_ROW, row);
    Conditions {
        force: given.unwrap_or_else(|| nominal(depth)),
        nominal: given.unwrap_or_else(|| nominal(setup.cut.depth)),
        nominal_depth: setup.cut.depth,
        set_depth,
    }
}
