//! The value that every row would show: the body through time, read at the places and times of the rows.

use super::body::Body;
use super::follow::{Followed, Look, Watch};
use super::machine::Machine;
use super::rows::{ELONGATION, TIME_OF_ROW, X, Y};
use super::setup::{MOST_STEPS, Time};
use super::{plate, rod};
use crate::process::{Failure, Rows};
use crate::solve::conduction::Run;
use crate::units::{TEMPERATURE_RISE, TIME};

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
    let run = Run { end, ..run(machine)? };
    refuse_too_many_steps(&run)?;
    let readings: Vec<(usize, f64)> = of_row.into_iter().zip(rows.columns[TIME_OF_ROW].iter().copied()).collect();
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
    let Time { scheme, end, .. } = machine.setup.time;
    Ok(Run { scheme, step: step(machine)?, end })
}

/// The longest step, s: that which the model gives, or one that is halved until what its own error changes
/// with the next halving, by the order of the scheme, is no more than the model's tolerance at any time and
/// place of the programme. It is chosen once, for the machine that is followed first: a fit sees the same
/// steps at all its trial values.
///
/// # Errors
/// The body cannot be computed, or no step is short enough.
fn step(machine: &Machine) -> Result<f64, Failure> {
    /// The first is this part of the run, the last the first halved so often.
    const FIRST: f64 = 1.0 / 50.0;
    const HALVINGS: i32 = 12;
    let setup = &machine.setup;
    if let Some(step) = setup.time.step {
        return Ok(step);
    }
    let choose = || {
        let looks: Vec<Look> = setup.places.iter().map(|x| Look::Rise { x: *x, y: None }).collect();
        let Time { scheme, end, tolerance, .. } = setup.time;
        let instant = Machine { lag: 0.0, ..machine.clone() };
        let at = |time: &f64| (0..looks.len()).map(|look| (look, *time)).collect::<Vec<_>>();
        let readings: Vec<(usize, f64)> = setup.times.iter().flat_map(at).collect();
        let seen = |step: f64| read(&instant, &looks, &readings, &Run { scheme, step, end });
        let mut coarse = seen(FIRST * end)?;
        for halved in 1..=HALVINGS {
            let step = FIRST * end * 0.5f64.powi(halved);
            let fine = seen(step)?;
            let apart = coarse.iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            if apart <= f64::from((1 << setup.time.order()) - 1) * tolerance {
                return Ok(step);
            }
            coarse = fine;
        }
        Err(Failure {
            message: format!("no time step leaves temperatures within {}", TEMPERATURE_RISE.told(tolerance)),
            help: "give a larger tolerance in [time], another scheme, or the step itself".into(),
        })
    };
    setup.chosen.get_or_init(choose).clone()
}
