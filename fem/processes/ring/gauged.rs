//! Readings of instruments off the deviations of a bore.

use std::f64::consts::TAU;
use std::ops::Range;

use super::circle::{evenly, form};
use super::instrument::Instrument;
use super::rows::{ANGLE_OF_ROW, BLANK, DEVIATION, DIAMETER};
use super::setup::Setup;
use crate::process::{Gauged, Rows, Values, spread};
use crate::roundness::{PER_WAVE, Places, gauss};

/// Points of a trace of which peak and valley are told, at least.
const POINTS: usize = 720;

/// Readings of rows that show more than one place of the bore, off the deviations of all of them; `None` where every row
/// shows its own place.
pub fn gauged(setup: &Setup, rows: &Rows) -> Option<Gauged> {
    let instrument = setup.instrument;
    if instrument.filter.is_none() && rows.observable.iter().all(|observable| *observable == DEVIATION) {
        return None;
    }
    let (mut of_row, mut angles, mut weights, mut spans) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    for (row, observable) in rows.observable.iter().enumerate() {
        // A trace begins at jaw 1.
        let at = rows.get(ANGLE_OF_ROW, row).filter(|_| *observable <= DIAMETER).unwrap_or(0.0);
        let places = places(instrument, *observable);
        spans.push((*observable, angles.len()..angles.len() + places.len()));
        for (beside, weight) in places {
            of_row.push(row);
            angles.push(at + beside);
            weights.push(weight);
        }
    }
    let mut profile = rows.some(&of_row);
    profile.columns[ANGLE_OF_ROW] = angles.clone().into();
    if !setup.blank.is_empty() {
        // What a row says of the blank is said of its own place.
        profile.columns[BLANK] = Values::shared(f64::NAN, of_row.len());
    }
    profile.observable = Values::shared(DEVIATION, of_row.len());
    let read = move |values: &[f64]| {
        let one = |(observable, span): &(usize, Range<usize>)| match *observable {
            DEVIATION | DIAMETER => span.clone().map(|i| weights[i] * values[i]).sum(),
            _ => peak_to_valley(&angles[span.clone()], &values[span.clone()], instrument.filter),
        };
        spans.iter().map(one).collect()
    };
    Some(Gauged::new(profile, read))
}

/// RONt of a trace at evenly spaced angles (rad): largest less smallest from the least-squares circle, behind the filter.
fn peak_to_valley(angles: &[f64], trace: &[f64], filter: Option<usize>) -> f64 {
    spread(&traced(angles, trace, filter))
}

/// Deviations (m) from the least-squares circle of a trace at evenly spaced angles (rad), behind the filter.
pub fn traced(angles: &[f64], trace: &[f64], filter: Option<usize>) -> Vec<f64> {
    let filtered = filter.map_or_else(|| trace.to_vec(), |cutoff| smoothed(trace, cutoff));
    form(angles, &filtered)
}

/// Evenly spaced angles (rad) of a trace that shows all that a filter lets through.
pub fn trace(filter: Option<usize>) -> Vec<f64> {
    let points = PER_WAVE * filter.unwrap_or(1);
    evenly(points * POINTS.div_ceil(points))
}

/// A closed trace at evenly spaced places, `PER_WAVE` or a multiple of it to a wave, behind the Gauss filter.
fn smoothed(trace: &[f64], cutoff: usize) -> Vec<f64> {
    let count = trace.len() as i64;
    let steps = |(at, weight): (f64, f64)| ((at / TAU * count as f64).round() as i64, weight);
    let kernel: Vec<(i64, f64)> = gauss(cutoff).into_iter().map(steps).collect();
    let one =
        |i: i64| kernel.iter().map(|(beside, weight)| weight * trace[(i + beside).rem_euclid(count) as usize]).sum();
    (0..count).map(one).collect()
}

/// The places of the bore whose sum a row of an observable shows.
fn places(instrument: Instrument, observable: usize) -> Places {
    match (observable, instrument.filter) {
        (DEVIATION, Some(cutoff)) => gauss(cutoff),
        (DEVIATION, None) => vec![(0.0, 1.0)],
        (DIAMETER, _) => instrument.gauge.contacts().places(),
        (_, filter) => trace(filter).into_iter().map(|at| (at, 1.0)).collect(),
    }
}
