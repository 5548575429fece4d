//! Deviations, diameters and roundness of the cut surface as they are measured: where around which set-up, in which state, and
//! how it was clamped and bored.

use std::collections::HashMap;

use super::circle::{self, evenly};
use super::setup::{Reference, Setup};
use crate::process::{
    Absent, CandidateExperiment, Coordinate, DatumDirection, Holds, Misplaced, Observable, Places, Rows, Values,
};
use crate::units::{ANGLE, FORCE, LENGTH, MICRO, SPINDLE_SPEED};

/// No part is as far off, m.
const FAR_OFF: f64 = 5e-3;

/// The radial deviation of the cut surface, positive outwards; what a gauge shows more than the set diameter; peak to valley
/// from the least-squares circle.
pub const OBSERVABLES: &[Observable] = &[
    Observable::within("deviation", "the ring", MICRO, FAR_OFF),
    Observable::within("diameter_error", "the diameter of the ring", MICRO, FAR_OFF),
    Observable::within("RONt", "the roundness of the ring", MICRO, FAR_OFF),
];

/// Positions in [`OBSERVABLES`].
pub const DEVIATION: usize = 0;
pub const DIAMETER: usize = 1;
pub const RONT: usize = 2;

/// Positions in [`COORDINATES`]: the angle from jaw 1.
pub const ANGLE_OF_ROW: usize = 0;
/// Released or clamped.
pub const STATE: usize = 1;
/// Force of each jaw.
pub const JAW_FORCE: usize = 2;
/// Speed while cutting.
pub const SPEED: usize = 3;
/// Deviation of the surface before it is cut.
pub const BLANK: usize = 4;
/// Number of the set-up.
pub const RUN: usize = 5;
/// Angle of the ring's mark.
pub const ORIENTATION: usize = 6;
/// Section, from the face at the chuck.
pub const SECTION: usize = 7;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new("angle", "from jaw 1", Holds::Quantity(ANGLE), Absent::NeededBut(RONT)),
    Coordinate::new("state", "cut and released, or clamped and not yet cut", Holds::word(STATES), Absent::Value(0.0)),
    Coordinate::new("jaw_force", "force of each jaw", Holds::Quantity(FORCE), Absent::Model),
    Coordinate::new("spindle_speed", "spindle speed while it is cut", Holds::Quantity(SPINDLE_SPEED), Absent::Model),
    Coordinate::new("blank", "radial deviation before it is cut", Holds::Quantity(MICRO), Absent::Model),
    Coordinate::new("run", "number of the set-up", Holds::Number(1), Absent::Value(1.0)),
    Coordinate::new("orientation", "the ring's mark from jaw 1", Holds::Quantity(ANGLE), Absent::Value(0.0)),
    Coordinate::new("z", "from the ring's face at the chuck", Holds::Quantity(LENGTH), Absent::Model),
];
const STATES: &[&str] = &["released", "clamped"];
/// Position in [`STATES`].
pub const CLAMPED: f64 = 1.0;

/// Rows that no chuck can give.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let check = |row: usize| {
        if let Some(z) = rows.get(SECTION, row).filter(|z| !(0.0..=setup.width * (1.0 + 1e-9)).contains(z)) {
            let [z, width] = [z, setup.width].map(|length| LENGTH.format(length));
            let message = format!("z = {z} is not on the ring, which is {width} wide");
            return Some(Misplaced { row, coordinate: SECTION, message });
        }
        let below = |column: &usize| rows.get(*column, row).is_some_and(|v| v < 0.0);
        // A gauge has contacts all around.
        if rows.observable[row] != DEVIATION && rows.get(BLANK, row).is_some_and(|v| v != 0.0) {
            let message = "`blank` is that of one place, and this row is read off places all around: leave it out and write \
                           the waves of the blank into [workpiece] blank";
            return Some(Misplaced { row, coordinate: BLANK, message: message.into() });
        }
        let coordinate = [JAW_FORCE, SPEED].into_iter().find(below)?;
        let message = format!("`{}` is below zero", COORDINATES[coordinate].name);
        Some(Misplaced { row, coordinate, message })
    };
    (0..rows.len()).filter_map(check).collect()
}

/// The released surface at some angles (rad) in a set-up of the model's own conditions, from a true blank.
fn set_up(setup: &Setup, run: f64, angles: Vec<f64>) -> Rows {
    let mut columns = vec![Values::shared(0.0, angles.len()); COORDINATES.len()];
    let own = [(JAW_FORCE, setup.jaw_force), (SPEED, setup.speed()), (RUN, run), (SECTION, setup.section)];
    for (column, value) in own {
        columns[column].fill(value);
    }
    let observable = Values::shared(DEVIATION, angles.len());
    columns[ANGLE_OF_ROW] = angles.into();
    Rows { columns, observable }
}

/// The released surface of the model's own ring at some angles, rad.
pub fn released(setup: &Setup, angles: Vec<f64>) -> Rows {
    let blank = angles.iter().map(|angle| setup.blank_at(*angle)).collect();
    let mut rows = set_up(setup, 1.0, angles);
    rows.columns[BLANK] = blank;
    rows
}

/// The model's own programme: the released surface all around, in one set-up.
pub fn programme(setup: &Setup) -> Rows {
    released(setup, evenly(setup.points))
}

/// What the surface of a row was off by before it was cut, m: the model's own where the row does not say.
pub fn blank(setup: &Setup, rows: &Rows, row: usize) -> f64 {
    rows.get(BLANK, row).unwrap_or_else(|| {
        let of = |column| rows.get(column, row).unwrap_or(0.0);
        setup.blank_at(of(ANGLE_OF_ROW) - of(ORIENTATION))
    })
}

/// Rows with force, speed and blank of the model where they have none of their own.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let mut resolved = rows.clone();
    resolved.columns[BLANK] = (0..rows.len()).map(|row| blank(setup, rows, row)).collect();
    for (column, value) in [(JAW_FORCE, setup.jaw_force), (SPEED, setup.speed()), (SECTION, setup.section)] {
        resolved.columns[column].fill_absent(value);
    }
    resolved
}

/// On the cut surface, set-up by set-up; a deviation is radial.
pub fn places(setup: &Setup, rows: &Rows) -> Places {
    let angle = |row| rows.get(ANGLE_OF_ROW, row).unwrap_or(0.0);
    let direction = |row: usize| [angle(row).cos(), angle(row).sin(), 0.0];
    let mut frames = vec![0.0; rows.len()];
    for (i, set_up) in set_ups(rows).iter().enumerate() {
        set_up.iter().for_each(|row| frames[*row] = 1.0 + i as f64);
    }
    Places {
        points: (0..rows.len()).map(|row| on_surface(setup, rows, row, direction(row))).collect(),
        directions: (0..rows.len()).map(direction).collect(),
        along: (0..rows.len()).map(angle).collect(),
        references: vec![0.0; rows.len()],
        frames,
    }
}

/// The place of a row in space, m; along the axis from the middle of the ring.
fn on_surface(setup: &Setup, rows: &Rows, row: usize, direction: [f64; 3]) -> [f64; 3] {
    let [x, y, _] = direction.map(|d| d * setup.cut_radius());
    [x, y, rows.get(SECTION, row).unwrap_or(setup.section) - 0.5 * setup.width]
}

/// The rows of each set-up: equal run, state, jaw force, spindle speed and section.
pub fn set_ups(rows: &Rows) -> Vec<Vec<usize>> {
    let mut numbers: HashMap<[u64; 5], usize> = HashMap::new();
    let mut set_ups: Vec<Vec<usize>> = Vec::new();
    for row in 0..rows.len() {
        let key = [RUN, STATE, JAW_FORCE, SPEED, SECTION].map(|column| rows.columns[column][row].to_bits());
        let number = *numbers.entry(key).or_insert(set_ups.len());
        if number == set_ups.len() {
            set_ups.push(Vec::new());
        }
        set_ups[number].push(row);
    }
    set_ups
}

/// Least-squares circle of every set-up, where deviations are measured from it.
pub fn datum_directions(setup: &Setup, rows: &Rows) -> Vec<DatumDirection> {
    match setup.reference {
        Reference::LeastSquaresCircle => {
            let angles = rows.columns[ANGLE_OF_ROW].to_vec();
            // A diameter has no circle that it is measured from.
            let traced =
                |own: &Vec<usize>| own.iter().copied().filter(|row| rows.observable[*row] == DEVIATION).collect();
            let traces: Vec<Vec<usize>> = set_ups(rows).iter().map(traced).collect();
            traces.iter().flat_map(|own| circle::directions(own, &angles)).collect()
        }
        Reference::Absolute => Vec::new(),
    }
}

/// Further experiments: another force or speed, a ring turned in the chuck, an oval blank, the clamped ring.
pub fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
    let next = 1.0 + (0..rows.len()).filter_map(|row| rows.get(RUN, row)).fold(0.0, f64::max);
    let angles: Vec<f64> = (0..36).map(|i| f64::from(10 * i).to_radians()).collect();
    let experiment = |words: &str, column: usize, value: &dyn Fn(f64) -> f64| {
        let mut rows = set_up(setup, next, angles.clone());
        rows.columns[column] = angles.iter().map(|angle| value(*angle)).collect();
        let mut values = rows.columns[column].to_vec();
        values.sort_unstable_by(f64::total_cmp);
        values.dedup();
        CandidateExperiment::new(words, &COORDINATES[column], values, rows)
    };
    let mut experiments = vec![
        experiment("cut another ring at half the jaw force", JAW_FORCE, &|_| 0.5 * setup.jaw_force),
        experiment("turn the ring by 45 deg in the chuck and cut it again", ORIENTATION, &|_| 45f64.to_radians()),
        experiment("cut a ring that is oval by 100 um before", BLANK, &|angle| 5e-5 * (2.0 * angle).cos()),
        experiment("measure the ring clamped, before it is cut", STATE, &|_| CLAMPED),
    ];
    if let Some([from, to]) = setup.reach {
        // The end that is farther from the jaws.
        let far = if from > setup.width - to { 0.0 } else { setup.width };
        experiments.push(experiment("measure the ring at its other end", SECTION, &|_| far));
    }
    if setup.speed() > 0.0 {
        experiments.push(experiment("cut another ring at half the spindle speed", SPEED, &|_| 0.5 * setup.speed()));
    }
    experiments
}
