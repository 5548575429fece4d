//! Solves for the command at which a machine makes what is meant.

use std::sync::Arc;

use crate::process::{Answers, Command, Commanded, Failure};

/// Steps after which what is not there yet will not come, of rows that answer to their own place, and of those that do not.
const MOST_STEPS: usize = 24;
const MOST_STEPS_ALONG: usize = 100;
/// Of those a step that leaves more than this part is the last: behind a jump of the command the drives stay behind, and who
/// drives them on makes them swing.
const LEAST_STEP: f64 = 0.9;
/// Errors below this are none, m.
pub const NONE: f64 = 1e-10;
/// Part of the largest error that is as good as none where rows do not answer to their own place alone.
const GOOD: f64 = 1e-3;
/// Range of what a change of the command does, in terms of what it does where nothing gives way.
const ANSWERS: (f64, f64) = (0.05, 3.0);

/// A secant in each of some values that answer to a change of their own alone.
pub struct Secants {
    gain: f64,
    slopes: Vec<f64>,
}

impl Secants {
    /// Those of so many values that answer by `gain` where nothing gives way.
    pub fn new(count: usize, gain: f64) -> Self {
        Self { gain, slopes: vec![gain; count] }
    }

    /// The changes that bring values to what is aimed at.
    pub fn steps(&self, now: &[f64], aims: &[f64]) -> Vec<f64> {
        now.iter().zip(aims).zip(&self.slopes).map(|((now, aim), slope)| (aim - now) / slope).collect()
    }

    /// Learns from what changes made of values.
    pub fn learn(&mut self, steps: &[f64], was: &[f64], now: &[f64]) {
        for (((slope, step), now), was) in self.slopes.iter_mut().zip(steps).zip(now).zip(was) {
            if step.abs() > NONE {
                *slope = ((now - was) / step / self.gain).clamp(ANSWERS.0, ANSWERS.1) * self.gain;
            }
        }
    }
}

/// A command, and what is made with it.
pub struct Solved {
    /// The command.
    pub command: Arc<Command>,
    /// What is left at every row.
    pub left: Vec<f64>,
    /// Rows that it does not bring to where they should be.
    pub unreached: usize,
}

/// The command with which `made` gives `aims`, from what it gives without one.
///
/// Where a row answers to the command at its own place alone, by a secant in every row. Where drives lag behind it, F, each
/// step adds what is missing: 1 − F is below one at every frequency, so that what is missing falls, the coarser the faster.
///
/// # Errors
/// What is made cannot be computed.
pub fn solve(
    nothing: &Command,
    (before, aims): (&[f64], &[f64]),
    commanded: &Commanded,
    made: impl Fn(&Arc<Command>) -> Result<Vec<f64>, Failure>,
) -> Result<Solved, Failure> {
    let worst = |made: &[f64]| made.iter().zip(aims).fold(0.0f64, |worst, (made, aim)| worst.max((made - aim).abs()));
    let (steps, good) = match commanded.answers {
        Answers::Here => (MOST_STEPS, NONE),
        Answers::Along => (MOST_STEPS_ALONG, NONE.max(GOOD * worst(before))),
    };
    let mut secants = Secants::new(before.len(), commanded.gain);
    let mut command = Arc::new(nothing.clone());
    let mut left = before.to_vec();
    for _ in 0..steps {
        if worst(&left) < good {
            break;
        }
        let steps = secants.steps(&left, aims);
        let changes = command.changes().iter().zip(&steps).map(|(change, step)| change + step).collect();
        let next = Arc::new(command.with(changes));
        let now = made(&next)?;
        if commanded.answers == Answers::Here {
            secants.learn(&steps, &left, &now);
        }
        let missing = |made: &[f64]| made.iter().zip(aims).map(|(made, aim)| (made - aim).powi(2)).sum::<f64>().sqrt();
        let is_last = commanded.answers == Answers::Along && missing(&now) > LEAST_STEP * missing(&left);
        if is_last && missing(&now) > missing(&left) {
            break;
        }
        (command, left) = (next, now);
        if is_last {
            break;
        }
    }
    let unreached = left.iter().zip(aims).filter(|(left, aim)| (*left - *aim).abs() > 1e2 * good).count();
    Ok(Solved { command, left, unreached })
}
