//! Displacements as they are measured: under which force, and on which branch.

use super::curve::Branch;
use super::setup::{Loading, Setup};
use crate::process::{Absent, CandidateExperiment, Coordinate, Holds, Misplaced, Observable, Rows, Values};
use crate::units::{FORCE, MICRO};

/// The displacement by which the joint gives way.
pub const OBSERVABLES: &[Observable] = &[Observable::new("displacement", "the displacement", MICRO).sensed()];

/// Positions in [`COORDINATES`]: the force.
pub const FORCE_OF_ROW: usize = 0;
/// Loading or unloading.
pub const BRANCH: usize = 1;
/// The place that is pushed.
pub const LOAD: usize = 2;
/// The dial that is read.
pub const DIAL: usize = 3;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new("force", "force on the joint", Holds::Quantity(FORCE), Absent::Refused),
    Coordinate::new(
        "branch",
        "whether the force rises, from nothing or from the other side, or falls from the largest",
        Holds::word(&["load", "unload"]),
        Absent::Value(0.0),
    ),
    Coordinate::new("load", "number of the place that is pushed", Holds::Number(1), Absent::Value(1.0)),
    Coordinate::new("dial", "number of the dial that is read", Holds::Number(1), Absent::Value(1.0)),
];

/// By how much a largest force may be told too small, as a part of it: people round.
const ROUNDED: f64 = 0.1;

/// The force at which loading ended, N: that of the model, or where rows go on beyond it the largest of theirs.
pub fn reached(max_force: f64, rows: &Rows) -> f64 {
    rows.columns[FORCE_OF_ROW].iter().fold(max_force, |most, force| most.max(force.abs()))
}

/// The branch of a row.
pub fn branch(rows: &Rows, row: usize) -> Branch {
    if rows.columns[BRANCH][row] == Branch::Unload.word() { Branch::Unload } else { Branch::Load }
}

/// The place that is pushed in a row, from 0.
pub fn load(rows: &Rows, row: usize) -> usize {
    rows.get(LOAD, row).map_or(0, |number| number as usize - 1)
}

/// The dial that is read in a row, from 0.
pub fn dial(rows: &Rows, row: usize) -> usize {
    rows.get(DIAL, row).map_or(0, |number| number as usize - 1)
}

/// Numbers of the places that are pushed and of the dials.
pub fn counts(setup: &Setup) -> (usize, usize) {
    setup.base.as_ref().map_or((1, 1), |base| (base.loads.len(), base.dials.len()))
}

/// Rows at places that the model does not have, and under forces that the test does not reach.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let (loads, dials) = counts(setup);
    let check = |row: usize| {
        for (coordinate, own, count, what) in
            [(LOAD, load(rows, row), loads, "places that are pushed"), (DIAL, dial(rows, row), dials, "dials")]
        {
            if own >= count {
                let message = format!("{} is beyond the {what} of the model, {count}", own + 1);
                return Some(Misplaced { row, coordinate, message });
            }
        }
        let force = rows.get(FORCE_OF_ROW, row)?;
        let message = match force {
            f if f < 0.0 && setup.loading == Loading::FromZero => {
                "`force` is below zero; a test with loading = \"reversed\" has such".to_string()
            }
            f if f.abs() > setup.max_force * (1.0 + ROUNDED) => {
                let [force, most] = [f, setup.max_force].map(|f| FORCE.shown(f));
                format!("{force} is beyond the test, which ends at max_force = {most}")
            }
            _ => return None,
        };
        Some(Misplaced { row, coordinate: FORCE_OF_ROW, message })
    };
    (0..rows.len()).filter_map(check).collect()
}

/// Rows of one branch, pushed at the first place and read off the first dial.
pub fn along(forces: Vec<f64>, branch: Branch) -> Rows {
    let count = forces.len();
    let columns = vec![forces.into(), Values::shared(branch.word(), count), Values::shared(1.0, count)];
    let dials = Values::shared(1.0, count);
    Rows { columns: columns.into_iter().chain([dials]).collect(), observable: Values::shared(0, count) }
}

/// The same rows pushed and read elsewhere, both from 0.
pub fn elsewhere(mut rows: Rows, load: usize, dial: usize) -> Rows {
    rows.columns[LOAD].fill(1.0 + load as f64);
    rows.columns[DIAL].fill(1.0 + dial as f64);
    rows
}

/// Rows of loading and then of unloading.
fn up_and_down(forces: &[f64]) -> Rows {
    along(forces.to_vec(), Branch::Load).and(&along(forces.iter().rev().copied().collect(), Branch::Unload))
}

/// The model's own programme: up, and down again, at every place and off every dial.
pub fn programme(setup: &Setup) -> Rows {
    let (loads, dials) = counts(setup);
    let all = (0..loads).flat_map(|load| (0..dials).map(move |dial| (load, dial)));
    let rows = all.map(|(load, dial)| elsewhere(up_and_down(&setup.forces()), load, dial));
    rows.reduce(|all, rows| all.and(&rows)).unwrap_or_default()
}

/// Further experiments: small forces finely, the whole loop finely, the other branch, and where loading begins at
/// no force the gauge before it.
pub fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
    let reversed = setup.loading == Loading::Reversed;
    let part = |to: f64, count: i32| -> Vec<f64> {
        let from = if reversed { -count } else { 1 };
        (from..=count).map(|i| setup.max_force * (to * f64::from(i) / f64::from(count))).collect()
    };
    let experiment = |words: String, coordinate: usize, values, rows| {
        CandidateExperiment::new(words, &COORDINATES[coordinate], values, rows)
    };
    let (fine, whole) = (part(0.1, 20), part(1.0, 50));
    let [step, end] = [0.005, 0.1].map(|part| FORCE.shown(part * setup.max_force));
    let begin = if reversed { format!("from {:.0} ", FORCE.shown(-0.1 * setup.max_force)) } else { String::new() };
    let words = format!("load once more in steps of {step:.1} {begin}up to {end:.0}");
    let again = "load and unload once more in steps of a fiftieth of the largest force".to_string();
    let mut experiments = Vec::new();
    if !reversed {
        let zeros = vec![0.0; 5];
        let unloaded = along(zeros.clone(), Branch::Load);
        let words = "read the gauge five times without force, before loading".into();
        experiments.push(experiment(words, FORCE_OF_ROW, zeros, unloaded));
    }
    experiments.push(experiment(words, FORCE_OF_ROW, fine.clone(), along(fine, Branch::Load)));
    experiments.push(experiment(again, FORCE_OF_ROW, whole.clone(), up_and_down(&whole)));
    let (loads, dials) = counts(setup);
    for (load, dial) in (0..loads).flat_map(|load| (0..dials).map(move |dial| (load, dial))) {
        let is_there = |row: usize| self::load(rows, row) == load && self::dial(rows, row) == dial;
        if loads * dials > 1 && !(0..rows.len()).any(is_there) {
            let words = format!("push at place {} and read dial {}", load + 1, dial + 1);
            let there = elsewhere(along(part(1.0, 5), Branch::Load), load, dial);
            experiments.push(experiment(words, DIAL, vec![1.0 + dial as f64], there));
        }
    }
    for (other, name) in [(Branch::Load, "loading"), (Branch::Unload, "unloading")] {
        if (0..rows.len()).all(|row| branch(rows, row) != other) {
            let words = format!("measure while {name}");
            experiments.push(experiment(words, BRANCH, vec![other.word()], along(whole.clone(), other)));
        }
    }
    experiments
}
