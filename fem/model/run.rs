//! A run: the prediction, and what each effect changes in it.

use super::Model;
use crate::process::{Active, Failure, Observable, Outcome, equip};
use crate::progress::Progress;
use crate::units::Kind;

/// What a run gives.
pub struct Run {
    /// The process's own report.
    pub outcome: Outcome,
    /// What each part of the model contributes to each observable, the ideal system first.
    pub shares: Vec<Share>,
}

/// What one effect changes: the prediction with all effects less the prediction without this one. For the ideal system, which has no effects,
/// its prediction itself. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Share {
    /// The effect's name, or `ideal`.
    pub name: &'static str,
    /// In which observable, by its position in the process's list.
    pub observable: usize,
    /// Root mean square over all points.
    pub rms: f64,
    /// Smallest change.
    pub smallest: f64,
    /// Largest change.
    pub largest: f64,
}

impl Share {
    /// In what it is told: the ideal prediction as what is observed, a change as errors are.
    pub fn kind(&self, observables: &[Observable]) -> Kind {
        let observable = &observables[self.observable];
        if self.name == "ideal" { observable.kind } else { observable.error_kind() }
    }
}

impl Model {
    /// Predicts, and compares the prediction with that of the model less each of its effects in turn.
    ///
    /// # Errors
    /// The computation failed.
    pub fn run(&self, progress: &Progress) -> Result<Run, Failure> {
        let job = self.job();
        let prediction = job.predict(progress)?;
        let mut changes = vec![("ideal", equip(&self.system, &[]).predict(progress)?)];
        for effect in &self.effects {
            let others: Vec<Active> = self.effects.iter().filter(|e| *e != effect).cloned().collect();
            let without = equip(&self.system, &others).predict(progress)?;
            let changed = prediction.iter().zip(&without).map(|(a, b)| a - b).collect();
            changes.push((effect.description.name, changed));
        }
        let programme = self.system.programme().observable;
        let observed = (0..self.process.observables().len()).filter(|o| programme.contains(o));
        let shares = observed.flat_map(|o| changes.iter().map(move |(name, changes)| (*name, o, changes)));
        let shares = shares.map(|(name, o, changes)| share(name, o, changes, &programme)).collect();
        Ok(Run { outcome: job.outcome(prediction)?, shares })
    }
}

/// Of the points of the programme at which this observable is predicted.
fn share(name: &'static str, observable: usize, changes: &[f64], programme: &[usize]) -> Share {
    let (mut square, mut count, mut smallest, mut largest) = (0.0, 0usize, f64::INFINITY, f64::NEG_INFINITY);
    for (change, _) in changes.iter().zip(programme).filter(|(_, o)| **o == observable) {
        square += change * change;
        count += 1;
        smallest = change.min(smallest);
        largest = change.max(largest);
    }
    Share { name, observable, rms: (square / count.max(1) as f64).sqrt(), smallest, largest }
}
