//! What a model leaves of the error when everything is commanded that the shop commands anyway: an offset for each part.

use std::sync::Arc;

use rayon::prelude::*;

use crate::compare::rms;
use crate::correct::{NONE, Secants, contours};
use crate::knowledge::Knowledge;
use crate::model::Model;
use crate::process::{Command, Commanded, Failure, Rows, Standing, System};

/// Steps after which an offset that is not there yet will not come.
const MOST_STEPS: usize = 8;
/// Most parts that are looked at.
pub const MOST_PARTS: usize = 16;
/// Standard deviations below which a normal value lies with a probability of 95 %.
const SURE: f64 = 1.645;
/// Draws of what is known roughly.
const DRAWS: usize = 200;

/// What is left, SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Left {
    /// Root mean square of the deviations from what is aimed at.
    pub rms: f64,
    /// The largest of them.
    pub worst: f64,
    /// The largest part of a tolerance that is used up: within all of them up to 1. None where nothing is asked.
    pub used: Option<f64>,
    /// The part that is not exceeded with a probability of 95 %, by how what is known roughly moves it.
    pub surely_used: Option<f64>,
}

impl Left {
    /// Whether all parts are within what is asked, with a probability of some 95 %.
    pub fn is_within(&self) -> bool {
        self.surely_used.is_some_and(|used| used <= 1.0)
    }

    /// What is to become small: the part of the tolerance that is used, or the error where nothing is asked.
    pub fn cost(&self) -> f64 {
        self.surely_used.unwrap_or(self.rms)
    }
}

/// The rows of a model, what is commanded, and what it makes.
pub struct Made {
    rows: Rows,
    command: Arc<Command>,
    /// What is left.
    pub left: Left,
    /// The errors at every row, for those who ask whether anything has changed.
    pub values: Vec<f64>,
}

impl Made {
    /// Makes the parts of a model as they come out with an offset for each of them, where its command takes one.
    ///
    /// # Errors
    /// The model cannot be computed.
    pub fn of(model: &Model) -> Result<Self, Failure> {
        let knowledge = Knowledge::of(model);
        let commanded = model.system.commanded().filter(Commanded::is_tool_offset);
        let (rows, nothing) = match &commanded {
            Some(own) => thinned(contours(model, own)),
            None => (lengths(model), Command::default()),
        };
        let made = |command: &Arc<Command>| observed(model, &knowledge.values, command, &rows);
        let mut command = Arc::new(nothing);
        let mut now = made(&command)?;
        let aims = model.system.aims(&rows);
        if let Some(own) = commanded {
            (command, now) = offset(command, now, &aims, own.gain, made)?;
        }
        let mut left = left(&*model.system, &rows, &now, &aims);
        if let Some(used) = left.used {
            // Values one standard deviation off that make no model say nothing.
            let moved = |values: Vec<f64>| {
                let now = observed(model, &values, &command, &rows).ok()?;
                Some(used_of(&*model.system, &rows, &now)? - used)
            };
            let square: f64 = knowledge
                .ways()
                .map(|way| knowledge.both_ways(way, 1.0))
                .filter_map(|[up, _]| moved(up))
                .map(|own| own * own)
                .sum();
            left.surely_used = Some(used + SURE * square.sqrt());
        }
        Ok(Self { rows, command, left, values: now })
    }

    /// Probability that all parts are within what is asked, with what is known of the values of the model; none where
    /// nothing is asked.
    pub fn probability(&self, model: &Model) -> Option<f64> {
        self.left.used?;
        let knowledge = Knowledge::of(model);
        if knowledge.uncertain() == 0 {
            return Some(f64::from(u8::from(is_in(self.left.used))));
        }
        let is_within = |number: usize| {
            let now = observed(model, &knowledge.drawn(number), &self.command, &self.rows).ok()?;
            Some(is_in(used_of(&*model.system, &self.rows, &now)))
        };
        // The first is what is known best; values that make no model are none.
        let further: Vec<bool> = (1..DRAWS).into_par_iter().filter_map(is_within).collect();
        let within = further.iter().filter(|own| **own).count() + usize::from(is_in(self.left.used));
        Some(within as f64 / (further.len() + 1) as f64)
    }
}

fn is_in(used: Option<f64>) -> bool {
    used.is_some_and(|used| used <= 1.0)
}

/// What rows show of parts made at some values.
fn observed(model: &Model, values: &[f64], command: &Arc<Command>, rows: &Rows) -> Result<Vec<f64>, Failure> {
    model.commanded_at(values, command)?.observe(rows)
}

/// Some parts of many, the first and the last among them: a trial is not to cost what a whole batch does.
fn thinned((rows, command): (Rows, Command)) -> (Rows, Command) {
    let contours = command.contours();
    if contours.len() <= MOST_PARTS {
        return (rows, command);
    }
    let kept = || (0..MOST_PARTS).map(|i| &contours[i * (contours.len() - 1) / (MOST_PARTS - 1)]);
    let own: Vec<usize> = kept().flat_map(|(_, own)| own.clone()).collect();
    let some = kept().map(|(apart, own)| (apart.clone(), command.places()[own.clone()].to_vec()));
    (rows.some(&own), Command::new(some, None))
}

/// The rows of a model's programme whose errors are told as its sizes are; all of them where there are none.
fn lengths(model: &Model) -> Rows {
    let programme = model.open_programme();
    let observables = model.process.observables();
    let is_length = |row: &usize| observables[programme.observable[*row]].error_kind() == model.process.size_kind();
    let own: Vec<usize> = (0..programme.len()).filter(is_length).collect();
    if own.is_empty() || own.len() == programme.len() { programme } else { programme.some(&own) }
}

/// The offset of each number with which the mean of its rows is where it should be, by a secant, and what is made with it.
fn offset(
    nothing: Arc<Command>,
    before: Vec<f64>,
    aims: &[f64],
    gain: f64,
    made: impl Fn(&Arc<Command>) -> Result<Vec<f64>, Failure>,
) -> Result<(Arc<Command>, Vec<f64>), Failure> {
    let places = nothing.contours().first().map_or(1, |(_, own)| own.len());
    let means = |now: &[f64]| -> Vec<f64> {
        let mean = |(now, aims): (&[f64], &[f64])| {
            now.iter().zip(aims).map(|(now, aim)| now - aim).sum::<f64>() / now.len() as f64
        };
        now.chunks(places).zip(aims.chunks(places)).map(mean).collect()
    };
    let (mut command, mut now) = (nothing, before);
    let mut off = means(&now);
    let (mut offsets, mut secants) = (vec![0.0; off.len()], Secants::new(off.len(), gain));
    let nothing = vec![0.0; off.len()];
    for _ in 0..MOST_STEPS {
        if off.iter().all(|own| own.abs() < NONE) {
            break;
        }
        let steps = secants.steps(&off, &nothing);
        offsets.iter_mut().zip(&steps).for_each(|(offset, step)| *offset += step);
        let changes = offsets.iter().flat_map(|change| std::iter::repeat_n(*change, places)).collect();
        command = Arc::new(command.with(changes));
        now = made(&command)?;
        let is = means(&now);
        secants.learn(&steps, &off, &is);
        off = is;
    }
    Ok((command, now))
}

fn left(system: &dyn System, rows: &Rows, now: &[f64], aims: &[f64]) -> Left {
    let off: Vec<f64> = now.iter().zip(aims).map(|(now, aim)| now - aim).collect();
    let worst = off.iter().fold(0.0f64, |worst, own| worst.max(own.abs()));
    let used = used_of(system, rows, now);
    Left { rms: rms(&off), worst, used, surely_used: used }
}

/// The largest part of a tolerance that parts use; none where nothing is asked.
fn used_of(system: &dyn System, rows: &Rows, now: &[f64]) -> Option<f64> {
    Standing::all(system, rows, now).iter().map(used).reduce(f64::max)
}

/// The part of the limits of a requirement that parts use: 1 for one that lies on a limit, 0 for one in the middle.
fn used(standing: &Standing) -> f64 {
    let (limits, [low, high]) = (standing.requirement.limits, standing.range());
    match limits.middle() {
        Some(middle) => (high - middle).max(middle - low) / (limits.upper - middle),
        None if limits.upper.is_finite() => high / limits.upper,
        None => limits.lower / low,
    }
}
