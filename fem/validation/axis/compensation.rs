//! The scheme of seed 001: six points there and back, and what a controller's tables leave.

use super::rig::*;
use crate::positioning::Direction::{Backward, Forward};
use crate::positioning::{Direction, Evaluation, Law, PitchErrors, Reversal, Steps, Table};
use crate::validation::Case;

/// P1 to P6 forwards and N6 to N1 backwards (um) at 0, 100, … 500 mm; as in the seed there is no reading at
/// P6 and none at N1.
const FORWARDS: [f64; 5] = [0.0, 4.0, 6.0, 11.0, 13.0];
const BACKWARDS: [f64; 5] = [10.0, 14.0, 17.0, 23.0, 24.0];

fn six_points() -> Evaluation {
    let forwards = FORWARDS.iter().enumerate().map(|(i, um)| (100.0 * i as f64, Forward, *um));
    let backwards = BACKWARDS.iter().enumerate().map(|(i, um)| (100.0 * (i + 1) as f64, Backward, *um));
    test(forwards.chain(backwards))
}

pub fn cases() -> Vec<Case> {
    let test = six_points();
    let reversal = Reversal::of(&test);
    let pitch = PitchErrors::of(&test);
    let points = Table::with_backlash(&test, Law::Points, 0.0);
    let segments = Table::with_backlash(&test, Law::Segments, 0.0);
    let rounded = Table::with_backlash(&test, Law::Points, 1e-6);
    let whole = Table::both_directions(&test, Law::Points, 0.0);
    let um = |name: &str, quantity, expected: f64, si: Option<f64>| {
        let computed = si.map_or(f64::NAN, |v| 1e6 * v);
        row(name, quantity, (expected, computed, "um"), CANCELLED, "seed 001, by hand")
    };
    let after = |table: &Table, i: usize, direction: Direction| {
        let target = test.targets.get(i)?;
        Some(target.side(direction)?.mean + table.correction(target.position, direction))
    };
    let correction = |table: &Table, mm: f64| Some(table.correction(1e-3 * mm, Forward));
    let lost = |i: usize| reversal.as_ref().and_then(|r| r.lost.get(i)).map(|b| b.1);
    // Added are 0, -3, -6, -10, -14, -16: in counts of 1 um times 2 these are 0, -2, -3, -5, -7, -8.
    let counts = points.increments(Steps { reference: 0.0, interval: 0.1, unit: 2e-6, magnification: 1, number: None });
    let counted = |name: &str, number: i64, expected: f64| {
        let own = counts.iter().find(|step| step.number == number).and_then(|step| step.counts);
        let computed = own.map_or(f64::NAN, |counts| counts as f64);
        row(name, "counts", (expected, computed, "-"), CANCELLED, "seed 001, by hand")
    };
    let relative = |i: usize| pitch.relative.get(i);
    vec![
        // N − P at the four inner targets: 6, 8, 6, 10.
        um("six points, second", "b", 6.0, lost(0)),
        um("six points, fifth", "b", 10.0, lost(3)),
        um("six points", "backlash value", 8.0, reversal.as_ref().map(|r| r.value)),
        um("six points", "rest of the reversal", 2.0, reversal.as_ref().map(|r| r.rest)),
        um("six points, second step forwards", "d+", 2.0, relative(1).and_then(|s| s.forward)),
        um("six points, second step backwards", "d-", 4.0, relative(1).and_then(|s| s.backward)),
        um("six points, second step", "d", 3.0, relative(1).and_then(|s| s.mean())),
        um("six points, first step, known forwards only", "d", 4.0, relative(0).and_then(|s| s.mean())),
        um("six points, last step, known backwards only", "d", 1.0, relative(4).and_then(|s| s.mean())),
        um("six points, fifth from the first", "D+", 13.0, pitch.absolute.get(4).and_then(|s| s.forward)),
        um("six points, sixth from the second, backwards", "D-", 14.0, pitch.absolute.get(5).and_then(|s| s.backward)),
        // Mean of P and N − 8: 3 at the second target, 6 at the third.
        um("point table, between second and third", "added", -4.5, correction(&points, 150.0)),
        um("segments, before midway", "added", -3.0, correction(&segments, 149.0)),
        um("segments, after midway", "added", -6.0, correction(&segments, 151.0)),
        um("point table, fifth target forwards", "left", -1.0, after(&points, 4, Forward)),
        um("point table, fifth target backwards", "left", 1.0, after(&points, 4, Backward)),
        um("point table, third target", "left", 0.0, after(&points, 2, Backward)),
        um("table of both directions, fifth target", "left", 0.0, after(&whole, 4, Backward)),
        um("table rounded to 1 um, at 150 mm", "added", -4.5, correction(&rounded, 150.0)),
        counted("increment at the first point in units of 1 um times 2", 1, -2.0),
        counted("increment at the third point in units of 1 um times 2", 3, -2.0),
        um("beyond the table", "added", -16.0, correction(&points, 900.0)),
    ]
}
