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

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new("force", "force on the joint", Holds::Quantity(FORCE), Absent::Refused),
    Coordinate::new(
        "branch",
        "whether the force rises, from nothing or from the other side, or falls from the largest",
        Holds::word(&["load", "unload"]),
        Absent::Value(0.0),
    ),
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

/// Rows under forces that the test does not reach.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let check = |row: usize| {
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

/// Rows of one branch.
pub fn along(forces: Vec<f64>, branch: Branch) -> Rows {
    let count = forces.len();
    Rows { columns: vec![forces.into(), Values::shared(branch.word(), count)], observable: Values::shared(0, count) }
}

/// Rows of loading and then of unloading.
fn up_and_down(forces: &[f64]) -> Rows {
    along(forces.to_vec(), Branch::Load).and(&along(forces.iter().rev().copied().collect(), Branch::Unload))
}

/// The model's own programme: up, and down again.
pub fn programme(setup: &Setup) -> Rows {
    up_and_down(&setup.forces())
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
    for (other, name) in [(Branch::Load, "loading"), (Branch::Unload, "unloading")] {
        if (0..rows.len()).all(|row| branch(rows, row) != other) {
            let words = format!("measure while {name}");
            experiments.push(experiment(words, BRANCH, vec![other.word()], along(whole.clone(), other)));
        }
    }
    experiments
}
