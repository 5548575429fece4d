//! The value that every row would show: the body through time, read at the places and times of the rows.

use std::sync::Arc;

use super::body::Body;
use super::follow::{Followed, Look, Watch};
use super::machine::Machine;
use super::recording::{Hottest, Picture, Recording};
use super::rows::{DIAMETER, ELONGATION, TIME_OF_ROW, X, Y};
use super::setup::{MOST_STEPS, Setup, Time};
use super::steps::Reading;
use super::{plate, rod};
use crate::process::{Failure, Rows};
use crate::solve::conduction::Run;
use crate::units::TIME;

/// Frames of a run beside its start.
const FRAMES: usize = 60;

/// The elongation (m), the temperature (K) or the change of a diameter (m) of every row.
///
/// # Errors
/// The body cannot be computed.
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    Asked::of(machine, rows)?.observed(machine, rows)
}

/// The same of the rows of the model's own programme: a plane body is followed once for them and for all else that is told of it.
///
/// # Errors
/// The body cannot be computed.
pub fn predict(machine: &Machine, programme: &Rows) -> Result<Vec<f64>, Failure> {
    let asked = Asked::of(machine, programme)?;
    if machine.setup.body.plane().is_none() || asked.run != run(machine)? {
        return asked.observed(machine, programme);
    }
    let Asked { mut looks, readings, run } = asked;
    for look in looks_at_shape(&machine.setup) {
        if !looks.contains(&look) {
            looks.push(look);
        }
    }
    let recording = Arc::new(recorded(machine, looks, run, |_, _| None)?);
    let lags = recording.looks.iter().map(|look| machine.lag_of(*look));
    let values = recording.track.clone().shown(lags, &readings);
    // A second prediction of one machine is the same.
    machine.recording.get_or_init(|| recording.clone());
    Ok(completed(machine, programme, values))
}

/// What some rows ask for.
struct Asked {
    /// Every look once.
    looks: Vec<Look>,
    /// Of every row the position of its look, and its time, s.
    readings: Vec<(usize, f64)>,
    /// The run that serves them.
    run: Run,
}

impl Asked {
    fn of(machine: &Machine, rows: &Rows) -> Result<Self, Failure> {
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
        Ok(Self { looks, readings, run })
    }

    /// What the rows show.
    fn observed(&self, machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        Ok(completed(machine, rows, read(machine, &self.looks, &self.readings, &self.run)?))
    }
}

/// Values of rows from what was read of the body.
fn completed(machine: &Machine, rows: &Rows, mut values: Vec<f64>) -> Vec<f64> {
    let commanded = |time: f64| machine.command.as_ref().map_or(0.0, |command| command.at(time, &[]));
    for (row, value) in values.iter_mut().enumerate() {
        *value += match rows.observable[row] {
            ELONGATION => commanded(rows.columns[TIME_OF_ROW][row]),
            DIAMETER => 0.0,
            _ => machine.setup.start,
        };
    }
    values
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

/// Follows a body with an eye on all nodes; `shown` is told the time (s) and the rises of all (K), and may give other ones to be
/// shown.
///
/// # Errors
/// It cannot be computed.
pub fn recorded(
    machine: &Machine,
    looks: Vec<Look>,
    run: Run,
    mut shown: impl FnMut(f64, &[f64]) -> Option<Vec<f64>>,
) -> Result<Recording, Failure> {
    let mut pictures: Vec<Picture> = Vec::new();
    let mut hottest: Option<Hottest> = None;
    let mut watch = |time: f64, rises: &dyn Fn() -> Vec<f64>| {
        let rises = rises();
        let shown = shown(time, &rises);
        let all = shown.as_ref().unwrap_or(&rises).iter().copied().enumerate();
        for (node, rise) in all.filter(|(_, rise)| rise.is_finite()) {
            // Of what is equal but for rounding the first.
            if hottest.is_none_or(|h| rise > h.rise + 1e-9 * rise.abs()) {
                hottest = Some(Hottest { node, rise, time });
            }
        }
        if time >= run.end * pictures.len() as f64 / FRAMES as f64 * (1.0 - 1e-9) {
            pictures.push(Picture { time, rises, shown });
        }
    };
    let Followed { track, energy } = follow(machine, &looks, &run, &mut watch)?;
    Ok(Recording { run, looks, track, energy, pictures, hottest })
}

/// What a run tells of the shape of a body.
pub fn looks_at_shape(setup: &Setup) -> Vec<Look> {
    let is_sheet = setup.body.plane().is_some_and(|plane| !plane.thickness.is_revolved());
    let ends = setup.body.has_ends().then_some(Look::Elongation);
    let circles = setup.circles.iter().map(|[x, y]| Look::Diameter { x: *x, y: Some(*y) });
    ends.into_iter().chain(is_sheet.then_some(Look::Bow)).chain(circles).collect()
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
