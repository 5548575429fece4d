//! Deviations of the bore as they are measured: where around which set-up, in which state, and how it was clamped and bored.

use super::circle;
use super::job::Ring;
use super::machine::Place;
use super::model::{Reference, Setup};
use crate::process::{Absent, Blind, Coordinate, Failure, Further, Holds, Misplaced, Observable, Places, Rows};
use crate::units::{ANGLE, FORCE, MICRO, SPINDLE_SPEED};

/// The radial deviation of the bore, positive outwards.
pub const OBSERVABLES: &[Observable] = &[Observable { name: "deviation", words: "the bore", kind: MICRO }];

/// Positions in [`COORDINATES`].
pub const ANGLE_OF_ROW: usize = 0;
/// Released or clamped.
pub const STATE: usize = 1;
/// Of each jaw.
pub const JAW_FORCE: usize = 2;
/// While boring.
pub const SPEED: usize = 3;
pub const BLANK: usize = 4;
/// The set-up.
pub const RUN: usize = 5;
pub const ORIENTATION: usize = 6;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    coordinate("angle", "from jaw 1", Holds::Quantity(ANGLE), Absent::Refused),
    coordinate("state", "bored and released, or clamped and not yet bored", Holds::Word(STATES), Absent::Value(0.0)),
    coordinate("jaw_force", "force of each jaw", Holds::Quantity(FORCE), Absent::Model),
    coordinate("spindle_speed", "spindle speed while boring", Holds::Quantity(SPINDLE_SPEED), Absent::Model),
    coordinate("blank", "radial deviation before boring", Holds::Quantity(MICRO), Absent::Value(0.0)),
    coordinate("run", "number of the set-up", Holds::Number(1), Absent::Value(1.0)),
    coordinate("orientation", "the ring's mark from jaw 1", Holds::Quantity(ANGLE), Absent::Value(0.0)),
];
const STATES: &[&str] = &["released", "clamped"];
/// Position in [`STATES`].
const CLAMPED: f64 = 1.0;

const fn coordinate(name: &'static str, about: &'static str, holds: Holds, absent: Absent) -> Coordinate {
    Coordinate { name, about, holds, absent, repeats: false }
}

/// Rows that no chuck can give.
pub fn misplaced(rows: &Rows) -> Vec<Misplaced> {
    let check = |row: usize| {
        let below = |column: &usize| rows.get(*column, row).is_some_and(|v| v < 0.0);
        let coordinate = [JAW_FORCE, SPEED].into_iter().find(below)?;
        let message = format!("`{}` is below zero", COORDINATES[coordinate].name);
        Some(Misplaced { row, coordinate, message })
    };
    (0..rows.len()).filter_map(check).collect()
}

/// The model's own programme: the released bore all around, in one set-up.
pub fn programme(setup: &Setup) -> Rows {
    let angles = setup.angles();
    let all = |value: f64| vec![value; angles.len()];
    let mut columns = vec![all(0.0); COORDINATES.len()];
    columns[JAW_FORCE] = all(setup.jaw_force);
    columns[SPEED] = all(setup.spindle_speed.unwrap_or(0.0));
    columns[BLANK] = angles.iter().map(|angle| setup.blank_at(*angle)).collect();
    columns[RUN] = all(1.0);
    let observable = vec![0; angles.len()];
    columns[ANGLE_OF_ROW] = angles;
    Rows { columns, observable }
}

/// Rows with force and speed of the model where they have none of their own.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let mut resolved = rows.clone();
    for (column, value) in [(JAW_FORCE, setup.jaw_force), (SPEED, setup.spindle_speed.unwrap_or(0.0))] {
        resolved.columns[column].iter_mut().filter(|v| v.is_nan()).for_each(|v| *v = value);
    }
    resolved
}

/// On the bore, set-up by set-up; a deviation is radial.
pub fn places(setup: &Setup, rows: &Rows) -> Places {
    let angle = |row| rows.get(ANGLE_OF_ROW, row).unwrap_or(0.0);
    let direction = |row: usize| [angle(row).cos(), angle(row).sin(), 0.0];
    let mut frames = vec![0.0; rows.len()];
    for (i, set_up) in circle::set_ups(rows).iter().enumerate() {
        set_up.iter().for_each(|row| frames[*row] = 1.0 + i as f64);
    }
    Places {
        points: (0..rows.len()).map(|row| direction(row).map(|d| d * setup.inner_radius)).collect(),
        directions: (0..rows.len()).map(direction).collect(),
        along: (0..rows.len()).map(angle).collect(),
        references: vec![0.0; rows.len()],
        frames,
    }
}

/// What the reference makes blind to.
pub fn blind(setup: &Setup, rows: &Rows) -> Vec<Blind> {
    match setup.reference {
        Reference::LeastSquaresCircle => circle::directions(rows),
        Reference::Absolute => Vec::new(),
    }
}

/// What every row shows, m.
///
/// # Errors
/// The ring cannot be computed.
pub fn observe(ring: &Ring, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let setup = ring.setup();
    let bore = ring.bore()?;
    let one = |row: usize| {
        let value = |column| rows.get(column, row);
        let angle = value(ANGLE_OF_ROW).unwrap_or(0.0);
        let force = value(JAW_FORCE).unwrap_or(setup.jaw_force);
        let unit = bore.radial(angle);
        if value(STATE) == Some(CLAMPED) {
            // Before boring, at standstill.
            return unit * force;
        }
        let speed = value(SPEED).or(setup.spindle_speed).unwrap_or(0.0);
        let (orientation, blank) = (value(ORIENTATION).unwrap_or(0.0), value(BLANK).unwrap_or(0.0));
        ring.marks_at(&Place { angle, orientation, blank }) - unit * ring.machine.force_at(force, speed)
    };
    let mut deviations: Vec<f64> = (0..rows.len()).map(one).collect();
    blind(setup, rows).iter().for_each(|direction| direction.take_out(&mut deviations));
    Ok(deviations)
}

/// What else could be measured beside these rows: other forces and speeds, a ring turned in the chuck, an oval blank, the clamped ring.
pub fn menu(setup: &Setup, rows: &Rows) -> Vec<Further> {
    let next = 1.0 + (0..rows.len()).filter_map(|row| rows.get(RUN, row)).fold(0.0, f64::max);
    let angles: Vec<f64> = (0..36).map(|i| f64::from(10 * i).to_radians()).collect();
    let further = |words: String, column: usize, values: &dyn Fn(f64) -> f64| {
        let mut columns = vec![vec![0.0; angles.len()]; COORDINATES.len()];
        columns[ANGLE_OF_ROW] = angles.clone();
        columns[JAW_FORCE] = vec![setup.jaw_force; angles.len()];
        columns[SPEED] = vec![setup.spindle_speed.unwrap_or(0.0); angles.len()];
        columns[RUN] = vec![next; angles.len()];
        columns[column] = angles.iter().map(|angle| values(*angle)).collect();
        let mut distinct = columns[column].clone();
        distinct.sort_unstable_by(f64::total_cmp);
        distinct.dedup();
        let rows = Rows { columns, observable: vec![0; angles.len()] };
        Further { words, coordinate: COORDINATES[column].name, values: distinct, rows }
    };
    let mut menu = vec![
        further("bore another ring at half the jaw force".into(), JAW_FORCE, &|_| 0.5 * setup.jaw_force),
        further("turn the ring by 45 deg in the chuck and bore it again".into(), ORIENTATION, &|_| 45f64.to_radians()),
        further("bore a ring whose bore is oval by 100 um before".into(), BLANK, &|angle| 5e-5 * (2.0 * angle).cos()),
        further("measure the ring clamped, before it is bored".into(), STATE, &|_| CLAMPED),
    ];
    if let Some(speed) = setup.spindle_speed.filter(|speed| *speed > 0.0) {
        menu.push(further("bore another ring at half the spindle speed".into(), SPEED, &|_| 0.5 * speed));
    }
    menu
}
