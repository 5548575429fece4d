//! Deviations as they are measured: which angle, from which side, in which run, when, under which torque.

use super::setup::Setup;
use crate::positioning::{Approach, Direction, Measures, Tolerance};
use crate::process::{
    Absent, Controller, Coordinate, Holds, Misplaced, Observable, Places, Positioning, ROUNDED, Rows, Values, finer,
};
use crate::units::{ANGLE, SMALL_ANGLE, TIME, TORQUE};

/// Actual less commanded angle.
pub const OBSERVABLES: &[Observable] = &[Observable::new("deviation", "the angle", SMALL_ANGLE)];

/// Positions in [`COORDINATES`]: the commanded angle.
pub const ANGLE_OF_ROW: usize = 0;
/// The side from which it is approached.
pub const DIRECTION: usize = 1;
/// The number of the run.
pub const RUN: usize = 2;
/// The time since the test began.
pub const TIME_OF_ROW: usize = 3;
/// The external torque about the axis, towards +.
pub const TORQUE_OF_ROW: usize = 4;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new("angle", "the commanded angle", Holds::Quantity(ANGLE), Absent::Refused).of_actual(0).with_curve(
        "angle-profile",
        "what drive and scale are off by at every target; a table of angles can take it out",
    ),
    Coordinate::new("direction", "of approach, + or -", Holds::word(DIRECTIONS), Absent::Refused),
    Coordinate::new("run", "number of the run", Holds::Number(1), Absent::Value(1.0)).repeating(),
    Coordinate::new("time", "since the test began, cold", Holds::Quantity(TIME), Absent::Value(0.0)),
    Coordinate::new(
        "torque",
        "external torque about the axis, positive towards +; `torque` of [test] if left out",
        Holds::Quantity(TORQUE),
        Absent::Model,
    ),
];
/// As files write them.
const DIRECTIONS: &[&str] = &[Direction::Forward.sign(), Direction::Backward.sign()];
/// Position in [`DIRECTIONS`].
pub const BACKWARD: f64 = 1.0;

/// The approach of a row.
pub fn approach(rows: &Rows, row: usize) -> Approach {
    let direction = match rows.columns[DIRECTION][row] {
        BACKWARD => Direction::Backward,
        _ => Direction::Forward,
    };
    Approach { position: rows.columns[ANGLE_OF_ROW][row], direction, run: rows.columns[RUN][row] }
}

/// The external torque of a row, N·m: its own, or that of the model's test.
pub fn torque(setup: &Setup, rows: &Rows, row: usize) -> f64 {
    rows.get(TORQUE_OF_ROW, row).unwrap_or(setup.test.torque)
}

/// The rows with the torque that they leave to the model.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let torques: Vec<f64> = (0..rows.len()).map(|row| torque(setup, rows, row)).collect();
    let mut rows = rows.clone();
    rows.columns[TORQUE_OF_ROW] = torques.into();
    rows
}

/// Rows that no test of this axis can give.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let [from, to] = [setup.from, setup.from + setup.range];
    let slack = ROUNDED * setup.range;
    let check = |row: usize| {
        if rows.columns[TIME_OF_ROW][row] < 0.0 {
            return Some(Misplaced { row, coordinate: TIME_OF_ROW, message: "`time` is below zero".into() });
        }
        let at = rows.columns[ANGLE_OF_ROW][row];
        let message = || format!("the axis turns from {} to {}", ANGLE.from_si(from), ANGLE.format(to));
        (at < from - slack || at > to + slack).then(|| Misplaced { row, coordinate: ANGLE_OF_ROW, message: message() })
    };
    (0..rows.len()).filter_map(check).collect()
}

/// Rows of approaches (angle, direction, run, time) under an external torque (N·m).
pub fn rows(approaches: impl IntoIterator<Item = (f64, Direction, f64, f64)>, torque: f64) -> Rows {
    let mut columns = vec![Values::default(); COORDINATES.len()];
    for (angle, direction, run, time) in approaches {
        columns[ANGLE_OF_ROW].push(angle);
        columns[DIRECTION].push(if direction == Direction::Backward { BACKWARD } else { 0.0 });
        columns[RUN].push(run);
        columns[TIME_OF_ROW].push(time);
        columns[TORQUE_OF_ROW].push(torque);
    }
    let observable = Values::shared(0, columns[ANGLE_OF_ROW].len());
    Rows { columns, observable }
}

/// Approaches to all targets forwards, then to all backwards, in a run; the time (s) of each by its number.
pub fn there_and_back(
    targets: &[f64],
    run: f64,
    time: impl Fn(usize) -> f64,
) -> impl Iterator<Item = (f64, Direction, f64, f64)> {
    let there = targets.iter().map(|x| (*x, Direction::Forward));
    let back = targets.iter().rev().map(|x| (*x, Direction::Backward));
    there.chain(back).enumerate().map(move |(i, (x, direction))| (x, direction, run, time(i)))
}

/// The model's own test: in every run all targets forwards, then all backwards.
pub fn programme(setup: &Setup) -> Rows {
    let (targets, test) = (&setup.targets(), setup.test);
    let run = |run: usize| {
        there_and_back(targets, (run + 1) as f64, move |i| run as f64 * test.round() + (i + 1) as f64 * test.reading)
    };
    rows((0..test.runs).flat_map(run), test.torque)
}

/// On a circle, run by run and direction by direction; a deviation is along it.
pub fn places(setup: &Setup, rows: &Rows) -> Places {
    let all = || 0..rows.len();
    let radius = setup.shown_radius();
    let angles = rows.columns[ANGLE_OF_ROW].to_vec();
    Places {
        points: angles.iter().map(|a| setup.point(*a, radius, 0.0)).collect(),
        directions: angles.iter().map(|a| setup.towards(*a).map(|c| radius * c)).collect(),
        references: vec![0.0; rows.len()],
        // Half a step from the way forwards to the way back.
        frames: all().map(|row| rows.columns[RUN][row] + 0.5 * rows.columns[DIRECTION][row]).collect(),
        along: angles,
    }
}

/// The targets that are measured, rising.
pub fn targets(rows: &Rows) -> Vec<f64> {
    let mut all = rows.columns[ANGLE_OF_ROW].to_vec();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup();
    all
}

impl Positioning for Setup {
    fn measures(&self) -> Measures {
        Measures::ROTARY
    }

    fn approaches(&self, rows: &Rows) -> Vec<Approach> {
        (0..rows.len()).map(|row| approach(rows, row)).collect()
    }

    fn is_free(&self, rows: &Rows, row: usize) -> bool {
        torque(self, rows, row) == self.test.torque
    }

    fn between(&self, of: &Rows) -> Rows {
        let targets = targets(of);
        let time = of.columns[TIME_OF_ROW].iter().sum::<f64>() / of.len().max(1) as f64;
        let places = finer(&targets);
        let both = Direction::BOTH.iter().flat_map(|d| places.iter().map(|x| (*x, *d, 1.0, time)));
        rows(both, self.test.torque)
    }

    fn tolerance(&self) -> Tolerance {
        self.tolerance
    }

    fn controller(&self) -> &Controller {
        &self.controller
    }

    fn reading_at_zero(&self) -> Option<f64> {
        self.test.reading_at_zero
    }

    fn screw_compliance(&self, _position: f64) -> Option<f64> {
        None
    }
}
