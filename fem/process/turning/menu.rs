//! What else a turned batch could be measured for: each asks one new question at the places that are measured already.

use std::collections::BTreeSet;

use super::model::Setup;
use super::observe::{BLANK, FORCE_OF_ROW, PART, PATH_OF_ROW, TIME_OF_ROW, X};
use crate::process::{Further, Rows};

/// Places of one further part, at most.
const PLACES: usize = 12;
/// Parts not measured yet, at most.
const PARTS: usize = 12;
/// Long enough for a machine to be cold again, s.
const REST: f64 = 4.0 * 3600.0;

/// The menu beside the given rows.
pub fn menu(setup: &Setup, rows: &Rows) -> Vec<Further> {
    let mut menu = Vec::new();
    let places = places(rows);
    let last = (0..rows.len()).filter_map(|r| rows.get(PART, r)).fold(1.0, f64::max);
    let part = |changes: &[(usize, f64)]| at(rows, &places, last, changes);
    let forces = levels(setup, rows);
    for force in new_forces(&forces) {
        let words = format!("turn another part with a radial force of {force:.0} N");
        menu.push(Further {
            words,
            coordinate: "radial_force",
            values: vec![force],
            rows: part(&[(FORCE_OF_ROW, force)]),
        });
    }
    let (time, path) = end(setup, last as usize);
    menu.push(Further {
        words: "let the machine rest for four hours and turn another part".into(),
        coordinate: "time",
        values: vec![time + REST],
        rows: part(&[(TIME_OF_ROW, time + REST), (PATH_OF_ROW, path)]),
    });
    let measured: BTreeSet<usize> = (0..rows.len()).map(|r| rows.get(PART, r).unwrap_or(1.0) as usize).collect();
    let missed: Vec<f64> =
        (1..=setup.schedule.parts).filter(|p| !measured.contains(p)).take(PARTS).map(|p| p as f64).collect();
    if !missed.is_empty() {
        let all = missed.iter().map(|p| at(rows, &places, *p, &[]));
        let rows = all.reduce(|a, b| a.and(&b)).unwrap_or_default();
        menu.push(Further {
            words: "measure the other parts of the batch too".into(),
            coordinate: "part",
            values: missed,
            rows,
        });
    }
    let stock = 2.0 * 1.6 * setup.cut.depth;
    menu.push(Further {
        words: format!("turn a part from a blank that is {:.2} mm larger than its finished diameter", 1e3 * stock),
        coordinate: "blank",
        values: vec![stock],
        rows: blanks(setup, part(&[]), stock),
    });
    let length = setup.length();
    let fine: Vec<f64> = (0..PLACES).map(|i| length * (0.01 + 0.98 * i as f64 / (PLACES - 1) as f64)).collect();
    let rows = at(rows, &fine, last, &[]);
    let words = format!("measure a part at {PLACES} places from end to end");
    menu.push(Further { words, coordinate: "x", values: fine, rows });
    menu
}

/// The places that are measured, or some of them.
fn places(rows: &Rows) -> Vec<f64> {
    let mut all: Vec<f64> = (0..rows.len()).filter_map(|r| rows.get(X, r)).collect();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup();
    let step = all.len().div_ceil(PLACES).max(1);
    all.into_iter().step_by(step).collect()
}

/// Rows of one part at places, with some coordinates set.
fn at(like: &Rows, places: &[f64], part: f64, changes: &[(usize, f64)]) -> Rows {
    let mut columns = vec![vec![f64::NAN; places.len()]; like.columns.len()];
    columns[X] = places.to_vec();
    columns[PART] = vec![part; places.len()];
    for &(column, value) in changes {
        columns[column] = vec![value; places.len()];
    }
    let observable = like.observable.first().copied().unwrap_or(0);
    Rows { columns, observable: vec![observable; places.len()] }
}

fn blanks(setup: &Setup, mut rows: Rows, stock: f64) -> Rows {
    rows.columns[BLANK] = rows.columns[X].iter().map(|x| setup.diameter(*x) + stock).collect();
    rows
}

/// The forces at which parts were turned, rising.
fn levels(setup: &Setup, rows: &Rows) -> Vec<f64> {
    let force = |r| rows.get(FORCE_OF_ROW, r).unwrap_or_else(|| setup.nominal_force());
    let mut all: Vec<f64> = (0..rows.len()).map(force).collect();
    all.sort_unstable_by(f64::total_cmp);
    all.dedup();
    all
}

/// Half of the smallest force, one and a half of the largest, and the middle of the widest gap.
fn new_forces(levels: &[f64]) -> Vec<f64> {
    let lowest = levels.first().copied().unwrap_or(0.0);
    let gap = levels.windows(2).max_by(|a, b| (a[1] / a[0]).total_cmp(&(b[1] / b[0])));
    let middle = gap.filter(|g| g[0] > 0.0).map(|g| (g[0] * g[1]).sqrt());
    let largest = levels.last().copied().unwrap_or(0.0);
    [0.5 * lowest, 1.5 * largest].into_iter().chain(middle).filter(|f| *f > 0.0).collect()
}

/// Time and cutting path at the end of a part.
fn end(setup: &Setup, part: usize) -> (f64, f64) {
    let to = setup.schedule.pass.to;
    (setup.schedule.time(part, to), setup.schedule.path(part, to))
}
