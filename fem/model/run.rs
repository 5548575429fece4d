//! A run: the prediction, and what each effect changes in it.

use super::Model;
use crate::process::{Active, Failure, Outcome, equip};
use crate::progress::Progress;

/// What a run gives.
pub struct Run {
    /// The process's own report.
    pub outcome: Outcome,
    /// What each part of the model contributes, the ideal system first.
    pub shares: Vec<Share>,
}

/// What one effect changes: the prediction with all effects less the prediction without this one. For the ideal system, which has no effects,
/// its prediction itself. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Share {
    /// The effect's name, or `ideal`.
    pub name: &'static str,
    /// Root mean square over all points.
    pub rms: f64,
    /// Smallest change.
    pub smallest: f64,
    /// Largest change.
    pub largest: f64,
}

impl Model {
    /// Predicts, and compares the prediction with that of the model less each of its effects in turn.
    ///
    /// # Errors
    /// The computation failed.
    pub fn run(&self, progress: &Progress) -> Result<Run, Failure> {
        let job = self.job();
        let prediction = job.predict(progress)?;
        let ideal = equip(&self.system, &[]).predict(progress)?;
        let mut shares = vec![share("ideal", ideal.iter().copied())];
        for effect in &self.effects {
            let others: Vec<Active> = self.effects.iter().filter(|e| *e != effect).cloned().collect();
            let without = equip(&self.system, &others).predict(progress)?;
            shares.push(share(effect.description.name, prediction.iter().zip(&without).map(|(a, b)| a - b)));
        }
        Ok(Run { outcome: job.outcome(prediction)?, shares })
    }
}

fn share(name: &'static str, changes: impl Iterator<Item = f64>) -> Share {
    let (mut square, mut count, mut smallest, mut largest) = (0.0, 0usize, f64::INFINITY, f64::NEG_INFINITY);
    for change in changes {
        square += change * change;
        count += 1;
        smallest = change.min(smallest);
        largest = change.max(largest);
    }
    Share { name, rms: (square / count.max(1) as f64).sqrt(), smallest, largest }
}
