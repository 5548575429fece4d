//! Displacements as they are measured: under which force, and on which branch.

use super::curve::Branch;
use super::job::Pushed;
use super::model::Setup;
use crate::process::{Absent, Coordinate, Further, Holds, Misplaced, Observable, Rows};
use crate::units::{FORCE, MICRO};

/// What the joint gives way by.
pub const OBSERVABLES: &[Observable] = &[Observable { name: "displacement", words: "the displacement", kind: MICRO }];

/// Positions in [`COORDINATES`].
pub const FORCE_OF_ROW: usize = 0;
/// Loading or unloading.
pub const BRANCH: usize = 1;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate {
        name: "force",
        about: "force on the joint",
        holds: Holds::Quantity(FORCE),
        absent: Absent::Refused,
        repeats: false,
    },
    Coordinate {
        name: "branch",
        about: "whether the force rises from nothing or falls from the largest",
        holds: Holds::Word(BRANCHES),
        absent: Absent::Value(0.0),
        repeats: false,
    },
];

/// The words for the branches.
pub const BRANCHES: &[&str] = &["load", "unload"];
/// Position in [`BRANCHES`].
pub const UNLOAD: f64 = 1.0;

/// The branch of a row's word.
pub fn branch(word: f64) -> Branch {
    if word == UNLOAD { Branch::Unload } else { Branch::Load }
}

/// Rows under forces that the test does not reach.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let check = |row: usize| {
        let force = rows.get(FORCE_OF_ROW, row)?;
        let message = match force {
            f if f < 0.0 => "`force` is below zero".to_string(),
            f if f > setup.max_force * (1.0 + 1e-9) => {
                format!("{f} N is beyond the test, which ends at max_force = {} N", setup.max_force)
            }
            _ => return None,
        };
        Some(Misplaced { row, coordinate: FORCE_OF_ROW, message })
    };
    (0..rows.len()).filter_map(check).collect()
}

/// Rows of one branch.
fn along(forces: Vec<f64>, branch: f64) -> Rows {
    let count = forces.len();
    Rows { columns: vec![forces, vec![branch; count]], observable: vec![0; count] }
}

/// The model's own programme: up, and down again.
pub fn programme(setup: &Setup) -> Rows {
    let up = setup.forces();
    let down = up.iter().rev().copied().collect();
    along(up, 0.0).and(&along(down, UNLOAD))
}

/// What every row shows, m.
pub fn observe(joint: &Pushed, rows: &Rows) -> Vec<f64> {
    let one = |row: usize| {
        let word = rows.get(BRANCH, row).unwrap_or(0.0);
        joint.curve.displacement(rows.get(FORCE_OF_ROW, row).unwrap_or(0.0), branch(word))
    };
    (0..rows.len()).map(one).collect()
}

/// What else could be measured beside these rows: small forces finely, the other branch, the whole loop finely.
pub fn menu(setup: &Setup, rows: &Rows) -> Vec<Further> {
    let part = |from: f64, to: f64, count: usize| -> Vec<f64> {
        (1..=count).map(|i| setup.max_force * (from + (to - from) * i as f64 / count as f64)).collect()
    };
    let further = |words: String, coordinate: &'static str, values: Vec<f64>, rows: Rows| Further {
        words,
        coordinate,
        values,
        rows,
    };
    let fine = part(0.0, 0.1, 20);
    let words =
        format!("load once more in steps of {:.1} N up to {:.0} N", 0.005 * setup.max_force, 0.1 * setup.max_force);
    let mut menu = vec![further(words, COORDINATES[FORCE_OF_ROW].name, fine.clone(), along(fine, 0.0))];
    let whole = part(0.0, 1.0, 50);
    let words = "load and unload once more in steps of a fiftieth of the largest force".to_string();
    let both = along(whole.clone(), 0.0).and(&along(whole.iter().rev().copied().collect(), UNLOAD));
    menu.push(further(words, COORDINATES[FORCE_OF_ROW].name, whole.clone(), both));
    let has = |word: f64| (0..rows.len()).any(|row| rows.get(BRANCH, row).unwrap_or(0.0) == word);
    for (word, name) in [(0.0, "loading"), (UNLOAD, "unloading")] {
        if !has(word) {
            let rows = along(whole.clone(), word);
            menu.push(further(format!("measure while {name}"), COORDINATES[BRANCH].name, vec![word], rows));
        }
    }
    menu
}
