//! Deviations of a ground cam as they are measured: where around, and how it was ground.

use super::job::Cam;
use super::machine::Pass;
use super::model::Setup;
use super::motion::{Motion, Ray};
use crate::process::{Absent, Coordinate, Failure, Further, Holds, Misplaced, Observable, Places, Rows};
use crate::units::{ANGLE, MICRO, SPINDLE_SPEED};

/// The deviation along the normal of the profile, positive outwards.
pub const OBSERVABLES: &[Observable] = &[Observable { name: "deviation", words: "the cam", kind: MICRO }];

/// Positions in [`COORDINATES`].
pub const ANGLE_OF_ROW: usize = 0;
/// Of the cam.
pub const SPEED: usize = 1;
pub const DIRECTION: usize = 2;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    coordinate("angle", "polar angle of the profile point", Holds::Quantity(ANGLE), Absent::Refused),
    coordinate("cam_speed", "mean speed of the cam while it was ground", Holds::Quantity(SPINDLE_SPEED), Absent::Model),
    coordinate(
        "direction",
        "the programme from its beginning, or from its end",
        Holds::Word(DIRECTIONS),
        Absent::Value(0.0),
    ),
];
const DIRECTIONS: &[&str] = &["forward", "reverse"];
/// Position in [`DIRECTIONS`].
const REVERSE: f64 = 1.0;

const fn coordinate(name: &'static str, about: &'static str, holds: Holds, absent: Absent) -> Coordinate {
    Coordinate { name, about, holds, absent, repeats: false }
}

/// Rows that no grinder can give.
pub fn misplaced(rows: &Rows) -> Vec<Misplaced> {
    let stands = |row: &usize| rows.get(SPEED, *row).is_some_and(|v| v <= 0.0);
    let misplaced = |row| Misplaced { row, coordinate: SPEED, message: "`cam_speed` is not above zero".into() };
    (0..rows.len()).filter(stands).map(misplaced).collect()
}

/// The model's own programme: once around, block by block.
pub fn programme(setup: &Setup) -> Rows {
    let angles: Vec<f64> = setup.places().into_iter().map(|s| setup.profile.angle(s)).collect();
    let all = |value: f64| vec![value; angles.len()];
    Rows { observable: vec![0; angles.len()], columns: vec![angles.clone(), all(setup.program.mean_speed), all(0.0)] }
}

/// Rows with the speed of the model where they have none of their own.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let mut resolved = rows.clone();
    resolved.columns[SPEED].iter_mut().filter(|v| v.is_nan()).for_each(|v| *v = setup.program.mean_speed);
    resolved
}

/// On the profile; each way of grinding is a frame.
pub fn places(setup: &Setup, rows: &Rows) -> Places {
    let angle = |row: usize| rows.get(ANGLE_OF_ROW, row).unwrap_or(0.0);
    let of = |row: usize| setup.profile.at(setup.profile.at_angle(angle(row)));
    let passes: Vec<Pass> = (0..rows.len()).map(|row| pass(setup, rows, row)).collect();
    let first = |row: usize| passes.iter().position(|p| *p == passes[row]).unwrap_or(row);
    Places {
        points: (0..rows.len()).map(|row| [of(row).point.x, of(row).point.y, 0.0]).collect(),
        directions: (0..rows.len()).map(|row| [of(row).normal.x, of(row).normal.y, 0.0]).collect(),
        along: (0..rows.len()).map(angle).collect(),
        references: vec![0.0; rows.len()],
        frames: (0..rows.len()).map(|row| first(row) as f64).collect(),
    }
}

fn pass(setup: &Setup, rows: &Rows, row: usize) -> Pass {
    let speed = rows.get(SPEED, row).unwrap_or(setup.program.mean_speed);
    Pass { speed, is_reversed: rows.get(DIRECTION, row) == Some(REVERSE) }
}

/// What every row shows, m.
///
/// # Errors
/// The wheel does not come to a point.
pub fn observe(cam: &Cam, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let setup = cam.setup();
    let mut motions: Vec<(Pass, Motion)> = Vec::new();
    let mut deviations = Vec::with_capacity(rows.len());
    for row in 0..rows.len() {
        let pass = pass(setup, rows, row);
        let known = motions.iter().position(|m| m.0 == pass);
        let i = known.unwrap_or(motions.len());
        if known.is_none() {
            motions.push((pass, cam.machine.motion(pass)));
        }
        let s = setup.profile.at_angle(rows.get(ANGLE_OF_ROW, row).unwrap_or(0.0));
        deviations.push(cam.deviation(&motions[i].1, s, pass)?);
    }
    Ok(deviations)
}

/// The deviation at the place s of a profile that a motion grinds, without what gives way; `None` where the wheel does not come.
pub fn left_at(setup: &Setup, motion: &Motion, s: f64, pass: Pass) -> Option<f64> {
    let block = setup.program.block_at(s);
    let executed = if pass.is_reversed { setup.program.blocks() - 1 - block } else { block };
    motion.left_along(&Ray::from(setup.profile.at(s)), motion.first_leg(executed)).map(|reach| reach.left)
}

/// What else could be measured beside these rows: other speeds, the other direction, and all around.
pub fn menu(setup: &Setup) -> Vec<Further> {
    let angles: Vec<f64> = (0..72).map(|i| f64::from(5 * i).to_radians()).collect();
    let further = |words: &str, column: usize, value: f64| {
        let mut columns = vec![vec![0.0; angles.len()]; COORDINATES.len()];
        columns[ANGLE_OF_ROW] = angles.clone();
        columns[SPEED].fill(setup.program.mean_speed);
        columns[column].fill(value);
        let rows = Rows { columns, observable: vec![0; angles.len()] };
        Further { words: words.into(), coordinate: COORDINATES[column].name, values: vec![value], rows }
    };
    vec![
        further("grind another cam at half the cam speed", SPEED, 0.5 * setup.program.mean_speed),
        further("grind another cam with the programme run from its end to its beginning", DIRECTION, REVERSE),
    ]
}
