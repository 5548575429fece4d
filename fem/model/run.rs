//! Runs a model: the prediction, and the change that each effect makes in it.

use super::Model;
use crate::input::Name;
use crate::process::{Absent, Active, Failure, ForwardModel, Observable, Rows, RunReport, Standing, Values};
use crate::progress::Progress;
use crate::units::Kind;

/// Result of a run.
#[non_exhaustive]
pub struct Run {
    /// Report of the process.
    pub report: RunReport,
    /// Prediction of every point of the model's own programme, SI.
    pub prediction: Vec<f64>,
    /// How the parts stand against what the drawing asks, as far as the model says.
    pub standings: Vec<Standing>,
    /// Contribution of each part of the model to each observable, the ideal system first.
    pub contributions: Vec<Contribution>,
    /// Parts of which none can be told.
    pub untold: Vec<Untold>,
}

/// A part of a model whose contribution cannot be told, for what it would be the difference from cannot be computed: as
/// where a joint opens under a force that only this effect keeps small.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Untold {
    /// Name of the effect, or `ideal`.
    pub name: Name,
    /// Why the machine without it, or without any effect, cannot be computed.
    pub why: Failure,
}

impl Untold {
    /// The same as a clause: whose contribution is not told, and why.
    pub fn clause(&self) -> String {
        let Self { name, why } = self;
        match &**name {
            "ideal" => format!("nothing is told of the machine without any effect: {why}"),
            _ => format!("what {name} changes is not told, for without it {why}"),
        }
    }
}

/// Change that one effect makes: the prediction with all effects less the prediction without this one; for
/// the ideal system, which has no effects, the prediction itself. SI units.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Contribution {
    /// Name of the effect, or `ideal`.
    pub name: Name,
    /// Observable that changes, by its position in the process's list.
    pub observable: usize,
    /// Root mean square over all points.
    pub rms: f64,
    /// Smallest change.
    pub smallest: f64,
    /// Largest change.
    pub largest: f64,
    /// Change at each point of the programme at which the observable is predicted.
    pub changes: Vec<f64>,
}

impl Contribution {
    /// Kind in which it is given: the ideal prediction in that of the observable, a change in that of its
    /// errors.
    pub fn kind(&self, observables: &[Observable]) -> Kind {
        let observable = &observables[self.observable];
        if self.name == "ideal" { observable.kind } else { observable.error_kind() }
    }
}

impl Model {
    /// Predicts, and compares the prediction with that of the model less each of its effects in turn.
    ///
    /// # Errors
    /// The prediction of the model itself failed; where that of a part of it does, the part is among [`Run::untold`].
    pub fn run(&self, progress: &Progress) -> Result<Run, Failure> {
        let forward = self.forward();
        let prediction = forward.predict(progress)?;
        let (mut changes, mut untold) = (Vec::new(), Vec::new());
        let mut note = |name: Name, found: Result<Vec<f64>, Failure>| match found {
            Ok(own) => changes.push((name, own)),
            Err(why) => untold.push(Untold { name, why }),
        };
        note(Name::new("ideal"), self.system.with_effects(&[]).predict(progress));
        for effect in &self.effects {
            note(effect.description.name.clone(), self.changes(effect, &prediction, progress));
        }
        let contributions = self.contributions(&changes);
        let standings = Standing::all(&*self.system, &self.system.programme(), &prediction);
        Ok(Run { report: forward.report(prediction.clone())?, prediction, standings, contributions, untold })
    }

    /// The rows of its programme without the conditions that it gives them itself: so they follow its values.
    pub fn open_programme(&self) -> Rows {
        let mut rows = self.system.programme();
        for (column, coordinate) in self.process.coordinates().iter().enumerate() {
            if coordinate.absent != Absent::Model {
                continue;
            }
            let written = std::mem::replace(&mut rows.columns[column], Values::shared(f64::NAN, rows.observable.len()));
            if self.system.resolved(&rows).columns[column] != written {
                rows.columns[column] = written;
            }
        }
        rows
    }

    /// Report of a run, without the contributions of its effects.
    ///
    /// # Errors
    /// The computation failed.
    #[doc(hidden)]
    pub fn report(&self, progress: &Progress) -> Result<RunReport, Failure> {
        let forward = self.forward();
        forward.report(forward.predict(progress)?)
    }

    /// Contribution of one of its effects to each observable, as a run has it: two predictions, and no report.
    ///
    /// # Errors
    /// The computation failed.
    #[doc(hidden)]
    pub fn contribution_of(&self, effect: &Active, progress: &Progress) -> Result<Vec<Contribution>, Failure> {
        let prediction = self.forward().predict(progress)?;
        Ok(self.contributions(&[(effect.description.name.clone(), self.changes(effect, &prediction, progress)?)]))
    }

    /// What one of its effects adds to rows, SI: their prediction, which is given, less that without the effect.
    ///
    /// # Errors
    /// The computation failed.
    #[doc(hidden)]
    pub fn change_in(&self, effect: &Active, predicted: &[f64], rows: &Rows) -> Result<Vec<f64>, Failure> {
        let without = self.behind(self.without(effect), &self.measurement).observe(rows)?;
        Ok(predicted.iter().zip(&without).map(|(a, b)| a - b).collect())
    }

    /// What is made of rows without one of its effects, SI, before no instrument.
    ///
    /// # Errors
    /// The computation failed.
    #[doc(hidden)]
    pub fn made_without(&self, effect: &Active, rows: &Rows) -> Result<Vec<f64>, Failure> {
        self.without(effect).observe(rows)
    }

    /// Contribution of an effect to every observation, SI: the prediction less that without the effect.
    fn changes(&self, effect: &Active, prediction: &[f64], progress: &Progress) -> Result<Vec<f64>, Failure> {
        let without = self.without(effect).predict(progress)?;
        Ok(prediction.iter().zip(&without).map(|(a, b)| a - b).collect())
    }

    /// The model without one of its effects.
    fn without(&self, effect: &Active) -> Box<dyn ForwardModel> {
        // The change of an effect goes with it.
        let own = &effect.description.name;
        let is_other = |e: &&Active| *e != effect && !e.description.is_change_of(own);
        let others: Vec<Active> = self.effects.iter().filter(is_other).cloned().collect();
        self.system.with_effects(&others)
    }

    /// Summaries of changes at every point of the programme, observable by observable.
    fn contributions(&self, changes: &[(Name, Vec<f64>)]) -> Vec<Contribution> {
        let programme = self.system.programme().observable;
        let observed = (0..self.process.observables().len()).filter(|o| programme.contains(o));
        let contributions =
            observed.flat_map(|o| changes.iter().map(move |(name, changes)| (name.clone(), o, changes)));
        contributions.map(|(name, o, changes)| contribution(name, o, changes, &programme)).collect()
    }
}

/// Summarises the changes at the points of the programme at which this observable is predicted.
fn contribution(name: Name, observable: usize, changes: &[f64], programme: &Values<usize>) -> Contribution {
    let own = changes.iter().zip(programme.iter()).filter(|(_, o)| **o == observable);
    let changes: Vec<f64> = own.map(|(change, _)| *change).collect();
    let square: f64 = changes.iter().map(|change| change * change).sum();
    Contribution {
        name,
        observable,
        rms: (square / changes.len().max(1) as f64).sqrt(),
        smallest: changes.iter().copied().fold(f64::INFINITY, f64::min),
        largest: changes.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        changes,
    }
}
