//! Remedies: which of the settings that a shop can change brings the parts closest to what is asked, what it costs in minutes,
//! which few do best together, and what more minutes would bring.
//!
//! What is judged is what is left with an offset for each part where the command takes one, for that costs nothing; of other
//! processes the error as it is. Where the model says what the drawing asks, the largest part of a tolerance that is used is
//! made small, and among settings with which all parts are within, the one with the fewest minutes is taken; where it does
//! not, the root mean square of the error.

mod bench;
mod combine;
mod left;
mod lever;
mod minimum;
mod search;

use rayon::prelude::*;

use crate::input::InputError;
use crate::model::{Edit, Model};
use crate::process::Failure;
use crate::progress::Progress;
use crate::units::Kind;
use bench::{Bench, Trial};
pub use left::Left;
use left::Made;
use lever::Lever;
pub use search::Refused;

/// Remedies of a model. SI.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Remedies {
    /// What is left now.
    pub now: Remedy,
    /// The best of each setting alone, the best first.
    pub alone: Vec<Remedy>,
    /// The best few together, where they are better than fewer.
    pub together: Vec<Remedy>,
    /// What each minute more brings: no other that was tried leaves less in less time. By rising time, with what is now.
    pub front: Vec<Remedy>,
    /// Settings that are left out, with the reasons.
    pub refused: Vec<Refused>,
    /// How many parts the minutes are of.
    pub parts: usize,
    /// How many of them are looked at, evenly from the first to the last.
    pub looked_at: usize,
    /// Whether an offset for each part is set in any case.
    pub by_offsets: bool,
    /// Most time more than now that was asked for, s.
    pub limit: Option<f64>,
    /// Values of the model that are known roughly.
    pub uncertain: usize,
    /// Evaluations of the model.
    pub evaluations: usize,
    /// Kind in which errors are told.
    #[doc(hidden)]
    pub kind: Kind,
}

/// Settings, and what they leave.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Remedy {
    /// What is changed.
    pub changes: Vec<Change>,
    /// What is left.
    pub left: Left,
    /// Time more than now, s, for all parts.
    pub time: f64,
    /// Probability that all parts are within what is asked; none where nothing is.
    pub probability: Option<f64>,
    /// The edits that make the model with it.
    #[doc(hidden)]
    pub edits: Vec<Edit>,
}

impl Remedies {
    /// What to do: the best of all, where anything is better than what is made now.
    pub fn best(&self) -> Option<&Remedy> {
        // Each that stands further is better than fewer.
        self.together.last().or(self.alone.first())
    }

    /// What a remedy gains: by how much the root mean square of the error falls.
    pub fn gain(&self, own: &Remedy) -> f64 {
        self.now.left.rms - own.left.rms
    }
}

/// A changed setting.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Change {
    /// Name of the setting.
    pub setting: String,
    /// What it is now; none where it is not there.
    pub from: Option<String>,
    /// What it should be; none where it is just done.
    pub to: Option<String>,
    /// Whether that is an end of its range.
    pub is_end: bool,
    /// Whether the model was held against measurements there; none where it is not said where it was.
    pub is_measured: Option<bool>,
}

/// Why there are no remedies.
#[derive(Clone, Debug)]
pub enum NoRemedy {
    /// A setting names what the model does not have.
    Input(InputError),
    /// The model cannot be computed.
    Compute(Failure),
}

impl From<Failure> for NoRemedy {
    fn from(failure: Failure) -> Self {
        Self::Compute(failure)
    }
}

/// Seeks remedies of a model whose values are known, which take at most `limit` (s) more than what is made now.
///
/// # Errors
/// A setting names what the model does not have, or the model cannot be computed.
pub fn remedies(model: &Model, limit: Option<f64>, progress: &Progress) -> Result<Remedies, NoRemedy> {
    let (levers, mut refused) = levers(model).map_err(NoRemedy::Input)?;
    let bench = Bench::new(model, levers, progress)?;
    let most = limit.unwrap_or(f64::INFINITY);
    let numbers: Vec<usize> = (0..bench.levers.len()).collect();
    let one = |lever: &usize| {
        let mut failed = Vec::new();
        (*lever, search::alone(&bench, *lever, most, &mut failed), failed)
    };
    let found: Vec<_> = progress.stretch("settings alone", || numbers.par_iter().map(one).collect());
    let (mut alone, mut silent): (Vec<(usize, Trial)>, Vec<usize>) = Default::default();
    for (lever, own, failed) in found {
        refused.extend(failed);
        match own {
            Ok(trial) => alone.push((lever, trial)),
            Err(reason) => {
                silent.push(lever);
                refused.push(reason);
            }
        }
    }
    // A stable order: equals stand as the model has them.
    alone.sort_by(|(_, a), (_, b)| combine::order(a, b));
    let together = progress.stretch("settings together", || combine::several(&bench, &alone, most));
    let nothing = bench.nothing();
    let (gains, vain): (Vec<_>, Vec<_>) = alone
        .into_iter()
        .partition(|(_, trial)| search::is_better(trial, &nothing) && combine::is_worth_it(trial, &nothing));
    refused.extend(vain.into_iter().map(|(lever, _)| Refused {
        name: bench.levers[lever].setting.name.clone(),
        reason: "is best as it is, alone and within its limits".into(),
        help: None,
    }));
    let heard: Vec<usize> = numbers.into_iter().filter(|own| !silent.contains(own)).collect();
    let chosen: Vec<Trial> = gains.iter().map(|(_, trial)| trial).chain(&together).cloned().collect();
    let front = progress.stretch("front", || combine::front(&bench, &heard, most, &chosen));
    let told = |trials: Vec<Trial>| progress.stretch("probabilities", || told(&bench, trials));
    let (alone, together) = (told(gains.into_iter().map(|(_, trial)| trial).collect()), told(together));
    let front = told(front);
    Ok(Remedies {
        now: told(vec![nothing]).remove(0),
        alone,
        together,
        front,
        refused,
        parts: bench.parts,
        looked_at: if model.system.commanded().is_some_and(|own| own.is_tool_offset()) {
            bench.parts.min(left::MOST_PARTS)
        } else {
            bench.parts
        },
        by_offsets: model.system.commanded().is_some(),
        limit,
        uncertain: crate::knowledge::Knowledge::of(model).uncertain(),
        evaluations: bench.tried().len(),
        kind: model.process.size_kind(),
    })
}

/// The settings of a model that it can judge, and those that it cannot.
fn levers(model: &Model) -> Result<(Vec<Lever<'_>>, Vec<Refused>), InputError> {
    let (mut levers, mut refused, mut wrong) = (Vec::new(), Vec::new(), Vec::new());
    for setting in &model.settings {
        let unheard = setting.varies.as_ref().and_then(|(path, _)| model.system.no_law(path));
        match (Lever::of(model, setting), unheard) {
            (Ok(lever), None) => levers.push(lever),
            (Ok(_), Some(own)) => refused.push(Refused {
                name: setting.name.clone(),
                reason: format!("cannot be judged: {}", own.reason),
                help: Some(own.help.into()),
            }),
            (Err(error), _) => wrong.extend(error.problems),
        }
    }
    if !wrong.is_empty() {
        return Err(InputError::new(model.source.clone(), wrong));
    }
    Ok((levers, refused))
}

/// Trials for people, with the probability of each.
fn told(bench: &Bench, trials: Vec<Trial>) -> Vec<Remedy> {
    trials.into_iter().map(|trial| remedy(bench, &trial)).collect()
}

fn remedy(bench: &Bench, trial: &Trial) -> Remedy {
    let change = |(lever, at): (&Lever, &Option<f64>)| {
        let at = (*at)?;
        Some(Change {
            setting: lever.setting.name.clone(),
            from: lever.now.clone(),
            to: lever.shown(at),
            is_end: lever.is_end(at),
            is_measured: lever.is_measured(at),
        })
    };
    let made = || {
        let model = bench.model_at(&trial.places).ok()?;
        Made::of(&model).ok()?.probability(&model)
    };
    Remedy {
        changes: bench.levers.iter().zip(&trial.places).filter_map(change).collect(),
        left: trial.left,
        time: trial.time,
        probability: made(),
        edits: bench.edits_at(&trial.places).unwrap_or_default(),
    }
}
