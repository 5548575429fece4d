//! Deviations as they are measured: which target, from which side, in which run, when.

use super::setup::Setup;
use crate::positioning::{Approach, Direction, Measures, Tolerance};
use crate::process::{
    Absent, CandidateExperiment, Controller, Coordinate, Holds, Misplaced, Observable, Places, Positioning, ROUNDED,
    Rows, Values, finer,
};
use crate::units::{FORCE, LENGTH, MICRO, TIME};

/// Actual less commanded position.
pub const OBSERVABLES: &[Observable] = &[Observable::new("deviation", "the position", MICRO)];

/// Positions in [`COORDINATES`]: the commanded position.
pub const POSITION: usize = 0;
/// The side from which it is approached.
pub const DIRECTION: usize = 1;
/// The number of the run.
pub const RUN: usize = 2;
/// The time since the test began.
pub const TIME_OF_ROW: usize = 3;
/// The force that pulls the slide towards -.
pub const PULL: usize = 4;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new("position", "the commanded position", Holds::Quantity(LENGTH), Absent::Refused)
        .of_actual(0)
        .with_curve("pitch-profile", "what screw and scale are off by at every target; a pitch table can take it out"),
    Coordinate::new("direction", "of approach, + or -", Holds::word(DIRECTIONS), Absent::Refused),
    Coordinate::new("run", "number of the run", Holds::Number(1), Absent::Value(1.0)).repeating(),
    Coordinate::new("time", "since the test began, cold", Holds::Quantity(TIME), Absent::Value(0.0)),
    Coordinate::new(
        "pull",
        "force that pulls the slide towards -, play not compensated meanwhile",
        Holds::Quantity(FORCE),
        Absent::Value(0.0),
    ),
];
/// As files write them.
const DIRECTIONS: &[&str] = &[Direction::Forward.sign(), Direction::Backward.sign()];
/// Position in [`DIRECTIONS`].
const BACKWARD: f64 = 1.0;

/// Long enough for an axis to be warm through, s.
const WARM: f64 = 2.0 * 3600.0;
/// Targets of a candidate experiment, at most.
const TARGETS: usize = 12;
/// Forces that pull the slide, N: beyond the friction of light slides and of heavy ones.
const PULLS: [f64; 2] = [1000.0, 4000.0];

/// The approach of a row.
pub fn approach(rows: &Rows, row: usize) -> Approach {
    let direction = match rows.columns[DIRECTION][row] {
        BACKWARD => Direction::Backward,
        _ => Direction::Forward,
    };
    Approach { position: rows.columns[POSITION][row], direction, run: rows.columns[RUN][row] }
}

/// Rows that no test of this axis can give.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let [from, to] = [setup.from, setup.from + setup.travel];
    let slack = ROUNDED * setup.travel;
    let check = |row: usize| {
        let (time, known) = (rows.columns[TIME_OF_ROW][row], setup.known_until());
        if rows.get(PULL, row).is_some_and(|pull| pull < 0.0) {
            return Some(Misplaced { row, coordinate: PULL, message: "`pull` is below zero".into() });
        }
        if time < 0.0 {
            return Some(Misplaced { row, coordinate: TIME_OF_ROW, message: "`time` is below zero".into() });
        }
        if time > known * (1.0 + 1e-9) {
            let message = format!("the record of the screw's temperature ends at {}", TIME.format(known));
            return Some(Misplaced { row, coordinate: TIME_OF_ROW, message });
        }
        let at = rows.columns[POSITION][row];
        let message = || format!("the axis travels from {} to {}", LENGTH.from_si(from), LENGTH.format(to));
        (at < from - slack || at > to + slack).then(|| Misplaced { row, coordinate: POSITION, message: message() })
    };
    (0..rows.len()).filter_map(check).collect()
}

/// Rows of approaches (position, direction, run, time).
pub fn rows(approaches: impl IntoIterator<Item = (f64, Direction, f64, f64)>) -> Rows {
    let mut columns = vec![Values::default(); COORDINATES.len()];
    for (position, direction, run, time) in approaches {
        columns[POSITION].push(position);
        columns[DIRECTION].push(if direction == Direction::Backward { BACKWARD } else { 0.0 });
        columns[RUN].push(run);
        columns[TIME_OF_ROW].push(time);
        columns[PULL].push(0.0);
    }
    let observable = Values::shared(0, columns[POSITION].len());
    Rows { columns, observable }
}

/// Approaches to all targets forwards, then to all backwards, in a run; the time (s) of each by its number.
fn there_and_back(
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
    rows((0..test.runs).flat_map(|run| {
        there_and_back(targets, (run + 1) as f64, move |i| run as f64 * test.round() + (i + 1) as f64 * test.reading)
    }))
}

/// On the axis, run by run and direction by direction; a deviation is along it.
pub fn places(rows: &Rows) -> Places {
    let all = || 0..rows.len();
    Places {
        points: all().map(|row| [rows.columns[POSITION][row], 0.0, 0.0]).collect(),
        directions: vec![[1.0, 0.0, 0.0]; rows.len()],
        along: rows.columns[POSITION].to_vec(),
        references: vec![0.0; rows.len()],
        // Half a step from the way forwards to the way back.
        frames: all().map(|row| rows.columns[RUN][row] + 0.5 * rows.columns[DIRECTION][row]).collect(),
    }
}

/// The targets that are measured, rising.
fn targets(rows: &Rows) -> Vec<f64> {
    let mut all = rows.columns[POSITION].to_vec();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup();
    all
}

/// Further experiments: other places of the turn, cold, warm, both sides, another order, the whole travel.
pub fn candidate_experiments(setup: &Setup, of: &Rows) -> Vec<CandidateExperiment> {
    let measured = targets(of);
    let some: Vec<f64> = measured.iter().copied().step_by(measured.len().div_ceil(TARGETS).max(1)).collect();
    let last = of.columns[TIME_OF_ROW].iter().copied().fold(0.0, f64::max);
    let run = 1.0 + of.columns[RUN].iter().copied().fold(0.0, f64::max);
    let at_once = |targets: &[f64], time: f64| rows(there_and_back(targets, run, |_| time));
    let experiment = |words: &str, coordinate: usize, values: Vec<f64>, rows| {
        CandidateExperiment::new(words, &COORDINATES[coordinate], values, rows)
    };
    let end = setup.from + setup.travel;
    let aside = |(i, x): (usize, &f64)| {
        let by = setup.lead * (0.13 + 0.25 * i as f64);
        if x + by <= end { x + by } else { x - by }
    };
    let moved: Vec<f64> = some.iter().enumerate().map(aside).filter(|x| (setup.from..=end).contains(x)).collect();
    let at_moved = rows(moved.iter().map(|x| (*x, Direction::Forward, run, last)));
    let both_sides = rows(some.iter().enumerate().flat_map(|(i, x)| {
        let time = last + setup.test.reading * (2 * i + 1) as f64;
        [(*x, Direction::Forward, run, time), (*x, Direction::Backward, run, time + setup.test.reading)]
    }));
    let mut experiments = vec![
        experiment(
            "let the axis stand until it is cold and measure all targets at once",
            TIME_OF_ROW,
            vec![0.0],
            at_once(&some, 0.0),
        )
        .taking(WARM),
        experiment(
            "keep the axis moving for two hours and measure all targets again",
            TIME_OF_ROW,
            vec![last + WARM],
            at_once(&some, last + WARM),
        )
        .taking(WARM),
        experiment(
            &format!("measure at {} other targets, each at another part of the screw's turn", moved.len()),
            POSITION,
            moved,
            at_moved,
        ),
        experiment(
            "approach each target from both sides before going on to the next",
            DIRECTION,
            vec![0.0, BACKWARD],
            both_sides,
        ),
    ];
    let covered = measured.last().zip(measured.first()).map_or(0.0, |(b, a)| b - a);
    if covered < 0.8 * setup.travel {
        let ends: Vec<f64> =
            (0..TARGETS).map(|i| setup.from + setup.travel * i as f64 / (TARGETS - 1) as f64).collect();
        let rows = at_once(&ends, last);
        experiments.push(experiment("measure from end to end of the travel, there and back", POSITION, ends, rows));
    }
    for pull in PULLS {
        let mut rows = at_once(&some, last);
        rows.columns[PULL].fill(pull);
        let force = FORCE.shown(pull);
        let words = format!(
            "pull the slide towards - with {force:.0}, its play not compensated, and measure all targets again"
        );
        experiments.push(experiment(&words, PULL, vec![pull], rows));
    }
    // What a recorded screw does beyond its record is not known.
    experiments.retain(|e| e.rows.columns[TIME_OF_ROW].iter().all(|time| *time <= setup.known_until()));
    experiments
}

impl Positioning for Setup {
    fn measures(&self) -> Measures {
        Measures::LINEAR
    }

    fn approaches(&self, rows: &Rows) -> Vec<Approach> {
        (0..rows.len()).map(|row| approach(rows, row)).collect()
    }

    fn is_free(&self, rows: &Rows, row: usize) -> bool {
        rows.get(PULL, row).is_none_or(|pull| pull == 0.0)
    }

    fn between(&self, of: &Rows) -> Rows {
        let targets = targets(of);
        let time = of.columns[TIME_OF_ROW].iter().sum::<f64>() / of.len().max(1) as f64;
        let places = finer(&targets);
        rows(Direction::BOTH.iter().flat_map(|d| places.iter().map(|x| (*x, *d, 1.0, time))))
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

    fn screw_compliance(&self, position: f64) -> Option<f64> {
        Some(self.screw().compliance(position))
    }
}
