//! Supports that rub: the tool is followed along its pass in small steps, and what the joints bore in one is where the next
//! begins.

use super::equilibrium::{at_rows, one_side};
use super::job::{Holding, Job, Row};
use super::set_up::between;
use crate::law::Cause;

/// Steps of the pass on the part before, and of the pass itself.
const STEPS: [usize; 2] = [12, 100];

/// Diameter error of every row, um, where headstock and tailstock rub with up to `most`, N.
pub fn errors(job: &Job, causes: &[Cause], most: [f64; 2]) -> Vec<f64> {
    let mut errors = vec![f64::NAN; job.rows.len()];
    for first in 0..job.rows.len() {
        if errors[first].is_nan() {
            let own: Vec<usize> = (0..job.rows.len()).filter(|i| is_of(&job.rows[first], &job.rows[*i])).collect();
            let left = pass(job, causes, most, &own);
            own.into_iter().zip(left).for_each(|(i, left)| errors[i] = left);
        }
    }
    errors
}

/// Whether two rows are of one pass, at one angle.
fn is_of(a: &Row, b: &Row) -> bool {
    let blank = a.blank.is_some() == b.blank.is_some();
    blank && (a.part, a.force, a.angle, a.radius_change) == (b.part, b.force, b.angle, b.radius_change)
}

/// Errors of rows of one pass.
fn pass(job: &Job, causes: &[Cause], most: [f64; 2], own: &[usize]) -> Vec<f64> {
    let supports = if job.holding == Holding::Chuck { 1 } else { 2 } + job.set_up.rests.len();
    let sides = if job.set_up.lobes.is_empty() { 1 } else { 2 };
    let mut borne = vec![vec![vec![0.0; supports]; job.set_up.passes.len() + 1]; sides];
    let mut found = Vec::new();
    for count in STEPS {
        // The tool has left the work, and friction keeps what it can; each pass finds what that before it left.
        for side in &mut borne {
            side.rotate_right(1);
            let keeps = |of: &mut Vec<f64>| {
                of.iter_mut().zip(most).for_each(|(bears, most)| *bears = bears.clamp(-most, most));
            };
            side.iter_mut().for_each(keeps);
        }
        let (places, steps) = steps(job, own, count);
        let along = Job { rows: steps, ..job.clone() };
        let mut number = 0;
        let left = at_rows(&along, causes, |row, at, exponent, angle| {
            at.rub(most);
            let side = &mut borne[number % sides];
            number += 1;
            one_side(&along, row, at, exponent, (angle, side))
        });
        found = own.iter().map(|i| left[places.iter().position(|x| *x == job.rows[*i].x).unwrap_or(0)]).collect();
    }
    found
}

/// Where the tool comes to in its order, mm, with rows of the pass there: blank and depth are straight between those that
/// are known.
fn steps(job: &Job, own: &[usize], count: usize) -> (Vec<f64>, Vec<Row>) {
    let length = job.shaft.length();
    let mut places: Vec<f64> = (0..=count).map(|i| length * i as f64 / count as f64).collect();
    places.extend(own.iter().map(|i| job.rows[*i].x));
    places.sort_by(f64::total_cmp);
    places.dedup();
    if !job.forward {
        places.reverse();
    }
    let first = job.rows[own[0]];
    let known = |of: &dyn Fn(&Row) -> Option<f64>| -> Vec<(f64, f64)> {
        let mut known: Vec<(f64, f64)> =
            own.iter().filter_map(|i| Some((job.rows[*i].x, of(&job.rows[*i])?))).collect();
        known.sort_by(|a, b| a.0.total_cmp(&b.0));
        known
    };
    let stock = known(&|row| Some(row.blank? - job.shaft.diameter(row.x)));
    let depths = known(&|row| row.depth);
    let row = |x: &f64| Row {
        x: *x,
        blank: between(&stock, *x).map(|stock| stock + job.shaft.diameter(*x)),
        depth: between(&depths, *x),
        ..first
    };
    let rows = places.iter().map(row).collect();
    (places, rows)
}
