//! Candidates of which these rows see no more than a curve, which many laws make: a small part of a turn, and times that
//! only rise with a place. They are not sought.

use std::f64::consts::{PI, TAU};

use nalgebra::{DVector, DVectorView};
use rayon::prelude::*;

use super::sensitivity::{self, CandidateEffect, LinearParameter, Variant};
use crate::fit::{Objective, Solution};
use crate::model::Data;
use crate::noise::time_of;
use crate::process::{Absent, Description, Rows, Values};
use crate::units::LENGTH;

/// Sensitivities of all `effects` about a solution of the model without them, without those that are like any curve.
pub fn candidates(objective: &Objective, base: &Solution, effects: &[Description]) -> Vec<CandidateEffect> {
    let mut all = sensitivity::candidates(objective, base, effects);
    let untimed = without_times(objective.data);
    all.par_iter_mut().for_each(|candidate| {
        candidate.variants.retain(turns_enough);
        let Some((first, rows)) = candidate.variants.first().zip(untimed.as_ref()) else { return };
        if acts_through_times(&objective.with(&candidate.effect), base, first, rows) {
            candidate.variants.clear();
        }
    });
    all
}

/// Whether the rows see half a period of what is a wave.
fn turns_enough(variant: &Variant) -> bool {
    /// Part of the largest value of a wave below which its phase at a row is round-off, and of a turn.
    const ROUND_OFF: f64 = 1e-6;
    let Some([sine, cosine]) = variant.wave() else { return true };
    let largest = sine.amax().max(cosine.amax());
    let is_seen = |(s, c): &(&f64, &f64)| s.hypot(**c) > ROUND_OFF * largest;
    let mut phases: Vec<f64> =
        sine.iter().zip(cosine.iter()).filter(is_seen).map(|(s, c)| s.atan2(*c).rem_euclid(TAU)).collect();
    phases.sort_by(f64::total_cmp);
    let Some((first, last)) = phases.first().zip(phases.last()) else { return true };
    let around = first + TAU - last;
    let widest = phases.windows(2).map(|two| two[1] - two[0]).fold(around, f64::max);
    widest <= PI + ROUND_OFF
}

/// Whether an effect makes something else of the rows when nobody has read a clock.
fn acts_through_times(trial: &Objective, base: &Solution, variant: &Variant, untimed: &Rows) -> bool {
    /// Part of what an effect makes that it makes through times, from which it acts through them.
    const THROUGH: f64 = 0.01;
    let predict = |own: Vec<f64>| {
        let all = base.position.iter().copied().chain(own);
        trial.predict_rows(&DVector::from_vec(all.collect()), untimed)
    };
    let Some(here) = predict(variant.position.clone()) else { return false };
    let is_other = |(parameter, column): (&LinearParameter, DVectorView<f64>)| {
        let mut moved = parameter.beside(&variant.position);
        moved[parameter.parameter] += parameter.size;
        predict(moved).is_some_and(|there| {
            let untimed = there.iter().zip(&here).map(|(there, here)| (there - here) / parameter.size);
            (DVector::from_vec(untimed.collect()) - column).norm() > THROUGH * column.norm()
        })
    };
    variant.linear.iter().zip(variant.raw.column_iter()).any(is_other)
}

/// The rows as if nobody had read a clock, where times of their own, not the model's, rise or fall with a place from the
/// first row to the last: the places come but once, and say all that the times do.
fn without_times(data: &Data) -> Option<Rows> {
    let coordinates = data.model.process.coordinates();
    let time = time_of(&*data.model.process).filter(|time| data.given.contains(time))?;
    let Absent::Value(unread) = coordinates[time].absent else { return None };
    let times = &data.rows.columns[time];
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|a, b| times[*a].total_cmp(&times[*b]));
    let goes_with = |place: usize| {
        let places = &data.rows.columns[place];
        let steps = || order.windows(2).map(|two| places[two[1]] - places[two[0]]);
        times.len() > 1 && (steps().all(|step| step > 0.0) || steps().all(|step| step < 0.0))
    };
    let is_place = |i: &usize| coordinates[*i].holds.kind() == Some(LENGTH);
    data.given.iter().copied().filter(is_place).any(goes_with).then(|| {
        let mut rows = data.rows.clone();
        rows.columns[time] = Values::shared(unread, times.len());
        rows
    })
}
