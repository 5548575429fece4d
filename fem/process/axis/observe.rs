//! Deviations as they are measured: which target, from which side, in which run, when.

use super::machine::Moment;
use super::model::Setup;
use crate::positioning::{Approach, Direction, Tolerance};
use crate::process::{Absent, Coordinate, Further, Holds, Misplaced, Observable, Places, Positioning, Rows};
use crate::units::{LENGTH, MICRO, TIME};

/// Actual less commanded position.
pub const OBSERVABLES: &[Observable] = &[Observable { name: "deviation", words: "the position", kind: MICRO }];

/// Positions in [`COORDINATES`].
pub const POSITION: usize = 0;
/// From which side.
pub const DIRECTION: usize = 1;
/// Number of the run.
pub const RUN: usize = 2;
/// Since the test began.
pub const TIME_OF_ROW: usize = 3;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    coordinate("position", "the commanded position", Holds::Quantity(LENGTH), Absent::Refused),
    coordinate("direction", "of approach, + or -", Holds::Word(DIRECTIONS), Absent::Refused),
    Coordinate { repeats: true, ..coordinate("run", "number of the run", Holds::Number(1), Absent::Value(1.0)) },
    coordinate("time", "since the test began, cold", Holds::Quantity(TIME), Absent::Value(0.0)),
];
/// As files write them.
pub const DIRECTIONS: &[&str] = &[Direction::Forward.sign(), Direction::Backward.sign()];
/// Position in [`DIRECTIONS`].
const BACKWARD: f64 = 1.0;

/// Steps between two targets where the model is asked for what lies between them.
const BETWEEN: usize = 24;
/// Long enough for an axis to be warm through, s.
const WARM: f64 = 2.0 * 3600.0;
/// Targets of a further test, at most.
const TARGETS: usize = 12;

const fn coordinate(name: &'static str, about: &'static str, holds: Holds, absent: Absent) -> Coordinate {
    Coordinate { name, about, holds, absent, repeats: false }
}

/// Which approach a row is.
pub fn moment(rows: &Rows, row: usize) -> Moment {
    let direction = match rows.columns[DIRECTION][row] {
        BACKWARD => Direction::Backward,
        _ => Direction::Forward,
    };
    Moment { position: rows.columns[POSITION][row], direction, time: rows.columns[TIME_OF_ROW][row] }
}

/// Rows that no test of this axis can give.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let [from, to] = [setup.from, setup.from + setup.travel];
    let slack = 1e-9 * setup.travel;
    let told = |row: usize| {
        if rows.columns[TIME_OF_ROW][row] < 0.0 {
            return Some(Misplaced { row, coordinate: TIME_OF_ROW, message: "`time` is below zero".into() });
        }
        let at = rows.columns[POSITION][row];
        let message = || format!("the axis travels from {} to {} mm", 1e3 * from, 1e3 * to);
        (at < from - slack || at > to + slack).then(|| Misplaced { row, coordinate: POSITION, message: message() })
    };
    (0..rows.len()).filter_map(told).collect()
}

/// Rows of approaches (position, direction, run, time).
pub fn rows(approaches: impl IntoIterator<Item = (f64, Direction, f64, f64)>) -> Rows {
    let mut columns = vec![Vec::new(); COORDINATES.len()];
    for (position, direction, run, time) in approaches {
        columns[POSITION].push(position);
        columns[DIRECTION].push(if direction == Direction::Backward { BACKWARD } else { 0.0 });
        columns[RUN].push(run);
        columns[TIME_OF_ROW].push(time);
    }
    let observable = vec![0; columns[POSITION].len()];
    Rows { columns, observable }
}

/// The model's own test: in every run all targets forwards, then all backwards.
pub fn programme(setup: &Setup) -> Rows {
    let targets = setup.targets();
    let there_and_back: Vec<(f64, Direction)> = targets
        .iter()
        .map(|x| (*x, Direction::Forward))
        .chain(targets.iter().rev().map(|x| (*x, Direction::Backward)))
        .collect();
    let count = there_and_back.len();
    let run = |run: usize| {
        let start = run as f64 * (count as f64 * setup.test.reading + setup.test.pause);
        let one = move |(i, (x, d)): (usize, &(f64, Direction))| {
            (*x, *d, (run + 1) as f64, start + (i + 1) as f64 * setup.test.reading)
        };
        there_and_back.iter().enumerate().map(one).collect::<Vec<_>>()
    };
    rows((0..setup.test.runs).flat_map(run))
}

/// On the axis, run by run and direction by direction; a deviation is along it.
pub fn places(rows: &Rows) -> Places {
    let all = || 0..rows.len();
    Places {
        points: all().map(|row| [rows.columns[POSITION][row], 0.0, 0.0]).collect(),
        directions: vec![[1.0, 0.0, 0.0]; rows.len()],
        along: rows.columns[POSITION].clone(),
        references: vec![0.0; rows.len()],
        // Half a step from the way forwards to the way back.
        frames: all().map(|row| rows.columns[RUN][row] + 0.5 * rows.columns[DIRECTION][row]).collect(),
    }
}

/// What else could be measured beside these rows: other places of the turn, cold, warm, both sides, another order.
pub fn menu(setup: &Setup, of: &Rows) -> Vec<Further> {
    let targets = some_targets(of);
    let all = |value: &dyn Fn(&Moment) -> f64| {
        let mut all: Vec<f64> = (0..of.len()).map(|row| value(&moment(of, row))).collect();
        all.sort_unstable_by(f64::total_cmp);
        all.dedup();
        all
    };
    let last = of.columns[TIME_OF_ROW].iter().copied().fold(0.0, f64::max);
    let run = 1.0 + of.columns[RUN].iter().copied().fold(0.0, f64::max);
    let both = |time: f64| {
        let forward = targets.iter().map(move |x| (*x, Direction::Forward, run, time));
        rows(forward.chain(targets.iter().rev().map(move |x| (*x, Direction::Backward, run, time))))
    };
    let moved: Vec<f64> = targets.iter().enumerate().map(|(i, x)| x + setup.lead * (0.13 + 0.25 * i as f64)).collect();
    let further = |words: String, coordinate, values, rows| Further { words, coordinate, values, rows };
    let at_moved = moved.iter().map(|x| (*x, Direction::Forward, run, last));
    let mut menu = vec![
        further(
            "let the axis stand until it is cold and measure all targets at once".into(),
            "time",
            vec![0.0],
            both(0.0),
        ),
        further(
            "keep the axis moving for two hours and measure all targets again".into(),
            "time",
            vec![last + WARM],
            both(last + WARM),
        ),
        further(
            format!("measure at {} other targets, each at another part of the screw's turn", moved.len()),
            "position",
            moved.clone(),
            rows(at_moved),
        ),
        further(
            "approach each target from both sides before going on to the next".into(),
            "direction",
            vec![0.0, BACKWARD],
            rows(targets.iter().enumerate().flat_map(|(i, x)| {
                let time = last + setup.test.reading * (2 * i + 1) as f64;
                [(*x, Direction::Forward, run, time), (*x, Direction::Backward, run, time + setup.test.reading)]
            })),
        ),
    ];
    let reached = all(&|at| at.position);
    let (low, high) = (setup.from, setup.from + setup.travel);
    let covered = reached.last().zip(reached.first()).map_or(0.0, |(b, a)| b - a);
    if covered < 0.8 * setup.travel {
        let ends: Vec<f64> = (0..TARGETS).map(|i| low + (high - low) * i as f64 / (TARGETS - 1) as f64).collect();
        let there = ends.iter().map(|x| (*x, Direction::Forward, run, last));
        let back = ends.iter().rev().map(|x| (*x, Direction::Backward, run, last));
        let rows = rows(there.chain(back));
        menu.push(further(
            "measure from end to end of the travel, there and back".into(),
            "position",
            ends.clone(),
            rows,
        ));
    }
    menu
}

/// The targets that are measured, or some of them.
fn some_targets(rows: &Rows) -> Vec<f64> {
    let mut all = rows.columns[POSITION].clone();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup();
    let step = all.len().div_ceil(TARGETS).max(1);
    all.into_iter().step_by(step).collect()
}

impl Positioning for Setup {
    fn approaches(&self, rows: &Rows) -> Vec<Approach> {
        let one = |row| {
            let Moment { position, direction, .. } = moment(rows, row);
            Approach { position, direction, run: rows.columns[RUN][row] }
        };
        (0..rows.len()).map(one).collect()
    }

    fn between(&self, of: &Rows) -> Rows {
        let mut targets = of.columns[POSITION].clone();
        targets.sort_unstable_by(f64::total_cmp);
        targets.dedup();
        let time = of.columns[TIME_OF_ROW].iter().sum::<f64>() / of.len().max(1) as f64;
        let fine =
            |w: &[f64]| (0..BETWEEN).map(|i| w[0] + (w[1] - w[0]) * i as f64 / BETWEEN as f64).collect::<Vec<_>>();
        let places: Vec<f64> = targets.windows(2).flat_map(fine).chain(targets.last().copied()).collect();
        rows(Direction::BOTH.iter().flat_map(|d| places.iter().map(|x| (*x, *d, 1.0, time))))
    }

    fn tolerance(&self) -> Tolerance {
        self.tolerance
    }

    fn resolution(&self) -> f64 {
        self.resolution
    }

    fn screw_compliance(&self, position: f64) -> f64 {
        self.screw().compliance(position)
    }
}
