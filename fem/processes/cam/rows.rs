//! Deviations of a ground cam as they are measured: where around, and how it was ground.

use super::program::Pass;
use super::setup::Setup;
use crate::process::{Absent, CandidateExperiment, Coordinate, Holds, Misplaced, Observable, Places, Rows, Values};
use crate::units::{ANGLE, MICRO, SPINDLE_SPEED};

/// No part is as far off, m.
const FAR_OFF: f64 = 5e-3;

/// The deviation along the normal of the profile, positive outwards.
pub const OBSERVABLES: &[Observable] = &[Observable::within("deviation", "the cam", MICRO, FAR_OFF).traced()];

/// Positions in [`COORDINATES`]: the polar angle of the point.
pub const ANGLE_OF_ROW: usize = 0;
/// The speed of the cam.
pub const SPEED: usize = 1;
/// The way the programme ran.
pub const DIRECTION: usize = 2;

/// The coordinates in the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new("angle", "polar angle of the profile point", Holds::Quantity(ANGLE), Absent::Refused),
    Coordinate::new(
        "cam_speed",
        "mean speed of the cam while it was ground",
        Holds::Quantity(SPINDLE_SPEED),
        Absent::Model,
    ),
    Coordinate::new(
        "direction",
        "the programme from its beginning, or from its end",
        Holds::word(&["forward", "reverse"]),
        Absent::Value(FORWARD),
    ),
];
const FORWARD: f64 = 0.0;
const REVERSE: f64 = 1.0;

/// The pass in which the cam of a row was ground.
pub fn pass(setup: &Setup, rows: &Rows, row: usize) -> Pass {
    let speed = rows.get(SPEED, row).unwrap_or(setup.program.mean_speed);
    Pass { speed, is_reversed: rows.get(DIRECTION, row) == Some(REVERSE) }
}

/// The place of the profile of a row, m.
pub fn place(setup: &Setup, rows: &Rows, row: usize) -> f64 {
    setup.profile.at_angle(rows.get(ANGLE_OF_ROW, row).unwrap_or(0.0))
}

/// Rows at polar angles (rad) of a cam that was ground so.
pub fn around(angles: Vec<f64>, pass: Pass) -> Rows {
    let count = angles.len();
    let direction = if pass.is_reversed { REVERSE } else { FORWARD };
    Rows {
        columns: vec![angles.into(), Values::shared(pass.speed, count), Values::shared(direction, count)],
        observable: Values::shared(0, count),
    }
}

/// Rows at places of the profile (m), ground as the programme runs.
pub fn at(setup: &Setup, places: &[f64]) -> Rows {
    around(places.iter().map(|s| setup.profile.angle(*s)).collect(), setup.program.usual())
}

/// The model's own programme: once around, block by block.
pub fn programme(setup: &Setup) -> Rows {
    at(setup, &setup.places())
}

/// Rows that no grinder can give.
pub fn misplaced(rows: &Rows) -> Vec<Misplaced> {
    let stands = |row: &usize| rows.get(SPEED, *row).is_some_and(|v| v <= 0.0);
    let misplaced = |row| Misplaced { row, coordinate: SPEED, message: "`cam_speed` is not above zero".into() };
    (0..rows.len()).filter(stands).map(misplaced).collect()
}

/// Rows with the speed of the model where they have none of their own.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let mut resolved = rows.clone();
    resolved.columns[SPEED].fill_absent(setup.program.mean_speed);
    resolved
}

/// Points on the profile; each way of grinding is a frame.
pub fn places(setup: &Setup, rows: &Rows) -> Places {
    let mut passes: Vec<Pass> = Vec::new();
    let mut places = Places { references: vec![0.0; rows.len()], ..Places::default() };
    for row in 0..rows.len() {
        let pass = pass(setup, rows, row);
        let frame = passes.iter().position(|p| *p == pass).unwrap_or_else(|| {
            passes.push(pass);
            passes.len() - 1
        });
        let place = setup.profile.at(place(setup, rows, row));
        places.points.push([place.point.x, place.point.y, 0.0]);
        places.directions.push([place.normal.x, place.normal.y, 0.0]);
        places.along.push(rows.get(ANGLE_OF_ROW, row).unwrap_or(0.0));
        places.frames.push(frame as f64);
    }
    places
}

/// Further experiments: another speed, the other direction, all around.
pub fn candidate_experiments(setup: &Setup) -> Vec<CandidateExperiment> {
    let usual = setup.program.usual();
    let experiment = |words: &str, column: usize, pass: Pass| {
        let rows = around((0..72).map(|i| f64::from(5 * i).to_radians()).collect(), pass);
        let values = vec![rows.columns[column][0]];
        CandidateExperiment::new(words, &COORDINATES[column], values, rows)
    };
    let slower = Pass { speed: 0.5 * usual.speed, ..usual };
    let reversed = Pass { is_reversed: true, ..usual };
    vec![
        experiment("grind another cam at half the cam speed", SPEED, slower),
        experiment("grind another cam with the programme run from its end to its beginning", DIRECTION, reversed),
    ]
}
