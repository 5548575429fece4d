//! The value that every row would show: the body through time, read at the places and times of the rows.

use super::body::Body;
use super::follow::{Followed, Look, Watch};
use super::machine::Machine;
use super::rows::{ELONGATION, TIME_OF_ROW, X, Y};
use super::setup::{MOST_STEPS, Time};
use super::steps::Reading;
use super::{plate, rod};
use crate::process::{Failure, Rows};
use crate::solve::conduction::Run;
use crate::units::TIME;

/// The elongation (m) or the temperature (K) of every row.
///
/// # Errors
/// The body cannot be computed.
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let look = |row: usize| match rows.observable[row] {
        ELONGATION => Look::Elongation,
        _ => Look::Rise { x: rows.get(X, row).unwrap_or(f64::NAN), y: rows.get(Y, row) },
    };
    let mut looks: Vec<Look> = Vec::new();
    let position = |row: usize| {
        let own = look(row);
        looks.iter().position(|l| *l == own).unwrap_or_else(|| {
            looks.push(own);
            looks.len() - 1
        })
    };
    let of_row: Vec<usize> = (0..rows.len()).map(position).collect();
    let end = rows.columns[TIME_OF_ROW].iter().copied().fold(0.0, f64::max);
    let readings: Vec<(usize, f64)> = of_row.into_iter().zip(rows.columns[TIME_OF_ROW].iter().copied()).collect();
    let run = Run { end, ..run_for(machine, &looks, &readings)? };
    refuse_too_many_steps(&run)?;
    let mut values = read(machine, &looks, &readings, &run)?;
    for (value, observable) in values.iter_mut().zip(rows.observable.iter()) {
        *value += if *observable == ELONGATION { 0.0 } else { machine.setup.start };
    }
    Ok(values)
}

/// Refuses rows that are read so late, or followed in steps so short, that nobody could wait for them.
fn refuse_too_many_steps(run: &Run) -> Result<(), Failure> {
    if run.end / run.step <= MOST_STEPS {
        return Ok(());
    }
    let (end, step) = (TIME.told(run.end), TIME.told(run.step));
    Err(Failure {
        message: format!("the rows reach to {end}, which is more than {MOST_STEPS} steps of {step}"),
        help: "check the unit of their column `time`, or take longer steps in [time]".into(),
    })
}

/// What is seen, each reading by the position of its look and its time (s).
fn read(machine: &Machine, looks: &[Look], readings: &[(usize, f64)], run: &Run) -> Result<Vec<f64>, Failure> {
    match &machine.setup.body {
        Body::Rod(segments) => rod::read(machine, segments, looks, readings, run),
        Body::Plane(plane) => {
            let Followed { track, .. } = plate::follow(machine, plane, looks, run, &mut |_, _| ())?;
            Ok(track.shown(looks.iter().map(|look| machine.lag_of(*look)), readings))
        }
    }
}

/// Follows a body from the start to the end of a run.
///
/// # Errors
/// It cannot be computed, or a place is not on it.
pub fn follow(machine: &Machine, looks: &[Look], run: &Run, watch: Watch) -> Result<Followed, Failure> {
    match &machine.setup.body {
        Body::Rod(segments) => rod::follow(machine, segments, looks, run, watch),
        Body::Plane(plane) => plate::follow(machine, plane, looks, run, watch),
    }
}

/// The run of the model, in its own steps.
///
/// # Errors
/// No step can be chosen.
pub fn run(machine: &Machine) -> Result<Run, Failure> {
    run_for(machine, &[], &[])
}

/// The run of the model in steps that serve these readings too, each by the position of its look and its time (s).
fn run_for(machine: &Machine, looks: &[Look], readings: &[(usize, f64)]) -> Result<Run, Failure> {
    let setup = &machine.setup;
    let Time { scheme, end, tolerance, step, .. } = setup.time;
    if let Some(step) = step {
        return Ok(Run { scheme, step, end });
    }
    let mut wanted: Vec<Reading> = Vec::new();
    for time in &setup.times {
        wanted.extend(setup.places.iter().map(|x| Reading::new(Look::Rise { x: *x, y: None }, *time, 0.0)));
    }
    // Of a shape no tolerance is said: it follows the temperatures.
    let rises = readings.iter().filter(|(look, _)| matches!(looks[*look], Look::Rise { .. }));
    wanted.extend(rises.map(|(look, time)| Reading::new(looks[*look], *time, machine.lag_of(looks[*look]))));
    let last = wanted.iter().map(Reading::time).fold(end, f64::max);
    let order = setup.time.order();
    let seen = |step: f64, wanted: &[Reading]| {
        let instant = Machine { lag: 0.0, ..machine.clone() };
        let mut values = vec![0.0; wanted.len()];
        for (machine, is_late) in [(&instant, false), (machine, true)] {
            let own: Vec<usize> = (0..wanted.len()).filter(|i| wanted[*i].is_late() == is_late).collect();
            let looks: Vec<Look> = own.iter().map(|i| wanted[*i].look()).collect();
            let readings: Vec<(usize, f64)> = own.iter().enumerate().map(|(k, i)| (k, wanted[*i].time())).collect();
            if !own.is_empty() {
                let read = read(machine, &looks, &readings, &Run { scheme, step, end: last })?;
                own.into_iter().zip(read).for_each(|(i, value)| values[i] = value);
            }
        }
        Ok(values)
    };
    let step = setup.steps.chosen(wanted, (end, tolerance, order), seen)?;
    Ok(Run { scheme, step, end })
}
