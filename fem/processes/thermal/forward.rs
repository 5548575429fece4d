//! The value that every row would show: the body through time, read at the places and times of the rows.

use super::body::Body;
use super::follow::{Followed, Look, Watch};
use super::machine::Machine;
use super::rows::{DIAMETER, ELONGATION, TIME_OF_ROW, X, Y};
use super::setup::{MOST_STEPS, Time};
use super::steps::Reading;
use super::{plate, rod};
use crate::process::{Failure, Rows};
use crate::solve::conduction::Run;
use crate::units::TIME;

/// The elongation (m), the temperature (K) or the change of a diameter (m) of every row.
///
/// # Errors
/// The body cannot be computed.
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let look = |row: usize| match rows.observable[row] {
        ELONGATION => Look::Elongation,
        DIAMETER => Look::Diameter { x: rows.get(X, row).unwrap_or(f64::NAN), y: rows.get(Y, row) },
        _ => Look::Rise { x: rows.get(X, row).unwrap_or(f64::NAN), y: rows.get(Y, row) },
    };
    let (looks, of_row) = numbered((0..rows.len()).map(look));
    let end = rows.columns[TIME_OF_ROW].iter().copied().fold(0.0, f64::max);
    let readings: Vec<(usize, f64)> = of_row.into_iter().zip(rows.columns[TIME_OF_ROW].iter().copied()).collect();
    let run = Run { end, ..run_for(machine, &looks, &readings)? };
    refuse_too_many_steps(&run)?;
    let mut values = read(machine, &looks, &readings, &run)?;
    let commanded = |time: f64| machine.command.as_ref().map_or(0.0, |command| command.at(time, &[]));
    for (row, value) in values.iter_mut().enumerate() {
        *value += match rows.observable[row] {
            ELONGATION => commanded(rows.columns[TIME_OF_ROW][row]),
            DIAMETER => 0.0,
            _ => machine.setup.start,
        };
    }
    Ok(values)
}

/// Every look once, and the position of each among them.
fn numbered(all: impl Iterator<Item = Look>) -> (Vec<Look>, Vec<usize>) {
    let mut looks: Vec<Look> = Vec::new();
    let position = |own: Look| {
        looks.iter().position(|look| *look == own).unwrap_or_else(|| {
            looks.push(own);
            looks.len() - 1
        })
    };
    let positions = all.map(position).collect();
    (looks, positions)
}

/// Refuses rows that are read so late, or followed in steps so short, that nobody could wait for them.
fn refuse_too_many_steps(run: &Run) -> Result<(), Failure> {
    if run.end / run.step <= MOST_STEPS {
        return Ok(());
    }
    let (end, step) = (TIME.format(run.end), TIME.format(run.step));
    Err(Failure {
        message: format!("the rows reach to {end}, which is more than {MOST_STEPS} steps of {step}"),
        help: "check the unit of their column `time`, or take longer steps in [time]".into(),
    })
}

/// Value of each reading, given by the position of its look and its time (s).
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
    let programme = || {
        let at = |time: &f64| {
            let time = *time;
            setup.places.iter().filter_map(move |x| Reading::of(Look::Rise { x: *x, y: None }, time, 0.0))
        };
        setup.times.iter().flat_map(at).collect()
    };
    let own = |(look, time): &(usize, f64)| Reading::of(looks[*look], *time, machine.lag_of(looks[*look]));
    let wanted: Vec<Reading> = readings.iter().filter_map(own).collect();
    let last = wanted.iter().map(Reading::time).fold(end, f64::max);
    let order = setup.time.order();
    let seen = |step: f64, wanted: &[Reading]| {
        let instant = Machine { lag: 0.0, ..machine.clone() };
        let mut values = vec![0.0; wanted.len()];
        for (machine, is_late) in [(&instant, false), (machine, true)] {
            let own: Vec<usize> = (0..wanted.len()).filter(|i| wanted[*i].is_late() == is_late).collect();
            if !own.is_empty() {
                let (looks, of_reading) = numbered(own.iter().map(|i| wanted[*i].look()));
                let readings: Vec<(usize, f64)> =
                    of_reading.into_iter().zip(&own).map(|(look, i)| (look, wanted[*i].time())).collect();
                let read = read(machine, &looks, &readings, &Run { scheme, step, end: last })?;
                own.into_iter().zip(read).for_each(|(i, value)| values[i] = value);
            }
        }
        Ok(values)
    };
    let step = setup.steps.chosen(&wanted, programme, (end, tolerance, order), seen)?;
    Ok(Run { scheme, step, end })
}
