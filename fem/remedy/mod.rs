//! Remedies: which of the settings that a shop can change brings the parts closest to what is asked, what it costs in minutes,
//! which few do best together, and what more minutes would bring.
//!
//! What is judged is what is left with an offset for each part where the command takes one, for that costs nothing; of other
//! processes the error as it is. Where the model says what the drawing asks, the largest part of a tolerance that is used is
//! made small, and among settings with which all parts are within, the one with the fewest minutes is taken; where it does
//! not, the root mean square of the error.

mod bench;
mod left;
mod lever;
mod minimum;
mod search;

use rayon::prelude::*;

use crate::input::InputError;
use crate::model::{Edit, Model};
use crate::process::Failure;
use crate::progress::Progress;
use bench::{Bench, Trial};
pub use left::Left;
use left::Made;
use lever::Lever;
pub use search::Refused;

/// Most settings that are tried together with others, and most of one combination.
const MOST_CANDIDATES: usize = 6;
/// Pairs to which a third setting is added.
const MOST_PAIRS: usize = 4;
/// Limits of time between the least and that of the best, at which less error is sought.
const LEVELS: usize = 4;
/// Most points of the front.
const MOST_POINTS: usize = 10;
/// Part of what is left by which several must be better than fewer.
const BETTER: f64 = 0.01;
/// Time by which several must be better than fewer, s.
const SOONER: f64 = 3.0;

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
    /// Whether an offset for each part is set in any case.
    pub by_offsets: bool,
    /// Most time more than now that was asked for, s.
    pub limit: Option<f64>,
    /// Values of the model that are known roughly.
    pub uncertain: usize,
    /// Evaluations of the model.
    pub evaluations: usize,
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
}

/// A changed setting.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Change {
    /// Name of the setting.
    pub setting: String,
    /// What it is now; none where it is not there.
    pub from: Option<String>,
    /// What it should be.
    pub to: String,
    /// Whether that is an end of its range.
    pub is_end: bool,
    /// Whether the model was not held against measurements there, as far as it is said where it was.
    pub is_beyond: bool,
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
        return Err(NoRemedy::Input(InputError::new(model.source.clone(), wrong)));
    }
    let bench = Bench::new(model, levers, progress)?;
    let most = limit.unwrap_or(f64::INFINITY);
    let numbers: Vec<usize> = (0..bench.levers.len()).collect();
    let found: Vec<_> = progress.stretch("settings alone", || {
        numbers.par_iter().map(|lever| (*lever, search::alone(&bench, *lever, most))).collect()
    });
    let mut alone: Vec<(usize, Trial)> = Vec::new();
    for (lever, own) in found {
        match own {
            Ok(trial) => alone.push((lever, trial)),
            Err(reason) => refused.push(reason),
        }
    }
    // A stable order: equals stand as the model has them.
    alone.sort_by(|(_, a), (_, b)| order(a, b));
    let together = progress.stretch("settings together", || several(&bench, &alone, most));
    let nothing = bench.nothing();
    let (gains, vain): (Vec<_>, Vec<_>) =
        alone.into_iter().partition(|(_, trial)| search::is_better(trial, &nothing) && is_worth_it(trial, &nothing));
    refused.extend(vain.into_iter().map(|(lever, _)| Refused {
        name: bench.levers[lever].setting.name.clone(),
        reason: "is best as it is, alone and within its limits".into(),
        help: None,
    }));
    let front = progress.stretch("front", || front(&bench, most));
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
        by_offsets: model.system.commanded().is_some(),
        limit,
        uncertain: crate::correct::Knowledge::of(model).uncertain(),
        evaluations: bench.tried().len(),
    })
}

/// The better trial first.
fn order(a: &Trial, b: &Trial) -> std::cmp::Ordering {
    match (search::is_better(a, b), search::is_better(b, a)) {
        (true, false) => std::cmp::Ordering::Less,
        (false, true) => std::cmp::Ordering::Greater,
        _ => std::cmp::Ordering::Equal,
    }
}

/// Whether a trial is better than another by more than nothing.
fn is_worth_it(trial: &Trial, than: &Trial) -> bool {
    let is_within = (trial.left.is_within(), than.left.is_within());
    match is_within {
        (true, false) => true,
        (true, true) => trial.time < than.time - SOONER || trial.left.cost() < (1.0 - BETTER) * than.left.cost(),
        _ => trial.left.cost() < (1.0 - BETTER) * than.left.cost(),
    }
}

/// The best pair, and the best three, where they are better than fewer.
fn several(bench: &Bench, alone: &[(usize, Trial)], limit: f64) -> Vec<Trial> {
    let candidates: Vec<usize> = alone.iter().take(MOST_CANDIDATES).map(|(lever, _)| *lever).collect();
    let mut places = vec![None; bench.levers.len()];
    for (lever, trial) in alone {
        places[*lever] = trial.places[*lever];
    }
    let go = |set: &[usize]| {
        let pairs = set.iter().enumerate().flat_map(|(i, a)| set[..i].iter().map(move |b| (*a, *b)));
        pairs.into_iter().all(|(a, b)| bench.levers[a].goes_with(&bench.levers[b]))
    };
    let sets = |larger: Vec<Vec<usize>>| -> Vec<(Vec<usize>, Trial)> {
        let all = larger.into_par_iter().filter(|set| go(set));
        let mut found: Vec<(Vec<usize>, Trial)> = all
            .filter_map(|set| search::together(bench, &set, &places, limit, &[]).map(|trial| (set, trial)))
            .collect();
        found.sort_by(|(_, a), (_, b)| order(a, b));
        found
    };
    let pairs = candidates.iter().enumerate().flat_map(|(i, a)| candidates[..i].iter().map(move |b| vec![*b, *a]));
    let pairs = sets(pairs.collect());
    let mut threes: Vec<Vec<usize>> = Vec::new();
    for (pair, _) in pairs.iter().take(MOST_PAIRS) {
        for third in candidates.iter().filter(|own| !pair.contains(own)) {
            let mut three = [&pair[..], &[*third]].concat();
            three.sort_unstable();
            if !threes.contains(&three) {
                threes.push(three);
            }
        }
    }
    let threes = sets(threes);
    let nothing = bench.nothing();
    let mut than = alone.first().map_or(nothing.clone(), |(_, own)| own.clone());
    if search::is_better(&nothing, &than) {
        than = nothing;
    }
    let mut chosen = Vec::new();
    for best in [pairs.first(), threes.first()].into_iter().flatten() {
        levels(bench, &best.0, &places, &best.1);
        if is_worth_it(&best.1, &than) && search::is_better(&best.1, &than) {
            than = best.1.clone();
            chosen.push(best.1.clone());
        }
    }
    chosen
}

/// Seeks what less time than the least error takes would leave, for the front.
fn levels(bench: &Bench, set: &[usize], places: &bench::Places, best: &Trial) {
    let of_set =
        |trial: &Trial| trial.places.iter().enumerate().all(|(lever, at)| at.is_some() == set.contains(&lever));
    let own: Vec<Trial> = bench.tried().into_iter().filter(of_set).collect();
    let least = own.iter().map(|trial| trial.time).fold(best.time, f64::min);
    let most = own.iter().min_by(|a, b| a.left.cost().total_cmp(&b.left.cost())).map_or(best.time, |trial| trial.time);
    if most - least > SOONER {
        let level = |i: usize| least + (most - least) * i as f64 / (LEVELS + 1) as f64;
        let all: Vec<f64> = (1..=LEVELS).map(level).collect();
        search::together(bench, set, places, all[LEVELS - 1], &all[..LEVELS - 1]);
    }
}

/// Trials than which no other leaves less in less time, by rising time.
fn front(bench: &Bench, limit: f64) -> Vec<Trial> {
    let least = |mut trials: Vec<Trial>| {
        trials.push(bench.nothing());
        trials.retain(|trial| trial.time <= limit + SOONER);
        trials.sort_by(|a, b| a.time.total_cmp(&b.time).then(a.left.cost().total_cmp(&b.left.cost())));
        let mut cost = f64::INFINITY;
        trials.retain(|trial| {
            let is_less = trial.left.cost() < (1.0 - BETTER) * cost;
            cost = if is_less { trial.left.cost() } else { cost };
            is_less
        });
        trials
    };
    let all = least(bench.tried());
    let thinned: Vec<Trial> = match all.len() {
        count if count > MOST_POINTS => {
            (0..MOST_POINTS).map(|i| all[i * (count - 1) / (MOST_POINTS - 1)].clone()).collect()
        }
        _ => all,
    };
    // What is told can be set.
    let set = |trial: &Trial| search::best(&search::settable(bench, trial), f64::INFINITY).cloned();
    let is_nothing = |trial: &Trial| trial.places.iter().all(Option::is_none);
    least(thinned.iter().filter(|own| !is_nothing(own)).filter_map(set).collect())
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
            is_beyond: lever.is_beyond(at),
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
