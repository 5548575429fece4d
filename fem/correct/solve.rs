//! Solves for the command at which a machine makes what is meant.

use std::sync::Arc;

use crate::process::{Command, Failure};

/// Steps after which what is not there yet will not come.
const MOST_STEPS: usize = 24;
/// Errors below this are none, m.
const NONE: f64 = 1e-10;
/// Range of what a change of the command does, in terms of what it does where nothing gives way.
const ANSWERS: (f64, f64) = (0.05, 3.0);

/// A command, and what is made with it.
pub struct Solved {
    /// The command.
    pub command: Arc<Command>,
    /// What is left at every row.
    pub left: Vec<f64>,
    /// Rows that it does not bring to where they should be.
    pub unreached: usize,
}

/// The command with which `made` gives `aims`, from what it gives without one, by a secant in every row: a row answers to the
/// command at its own place alone.
///
/// # Errors
/// What is made cannot be computed.
pub fn solve(
    nothing: &Command,
    (before, aims): (&[f64], &[f64]),
    gain: f64,
    made: impl Fn(&Arc<Command>) -> Result<Vec<f64>, Failure>,
) -> Result<Solved, Failure> {
    let mut slopes = vec![gain; before.len()];
    let mut command = Arc::new(nothing.clone());
    let mut left = before.to_vec();
    for _ in 0..MOST_STEPS {
        let worst = left.iter().zip(aims).fold(0.0f64, |worst, (left, aim)| worst.max((left - aim).abs()));
        if worst < NONE {
            break;
        }
        let steps: Vec<f64> =
            left.iter().zip(aims).zip(&slopes).map(|((left, aim), slope)| (aim - left) / slope).collect();
        let changes = command.changes.iter().zip(&steps).map(|(change, step)| change + step).collect();
        let next = Arc::new(Command { changes, ..(*command).clone() });
        let now = made(&next)?;
        for (((slope, step), now), was) in slopes.iter_mut().zip(&steps).zip(&now).zip(&left) {
            if step.abs() > NONE {
                *slope = ((now - was) / step / gain).clamp(ANSWERS.0, ANSWERS.1) * gain;
            }
        }
        (command, left) = (next, now);
    }
    let unreached = left.iter().zip(aims).filter(|(left, aim)| (*left - *aim).abs() > 1e2 * NONE).count();
    Ok(Solved { command, left, unreached })
}
