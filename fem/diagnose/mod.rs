//! Diagnoses which effect is missing: a search over all effects that the process knows and the model does
//! not have.
//!
//! The model's own free parameters are re-fitted together with every candidate effect; sets of effects grow
//! while Δχ² is more than chance gives to a search as wide (look-elsewhere effect); and confounded effects
//! are named beside those that are found. Structure that no effect explains is described, not explained.

mod alternatives;
mod bent_law;
mod candidate_model;
mod cautions;
mod change;
mod coarseness;
mod conclude;
mod confounding;
mod contender;
mod cross_validation;
mod detection_limit;
mod diagnosis;
mod doubtful;
mod explore;
mod failure;
mod few_places;
mod findings;
mod free_law;
mod gain;
mod hypothesis;
mod instrument;
mod judge;
mod laplace;
mod largest_change;
mod lead;
mod like_a_curve;
mod look_alike;
mod missing;
mod model_average;
mod moves;
mod next;
mod null_distribution;
mod on_trial;
mod outlook;
mod pairs;
mod plan;
mod pool;
mod posterior;
mod prior_conflict;
mod prospect;
mod residual_projection;
mod screening;
mod search;
mod sensitivity;
mod settle;
mod strain;
mod under_noise;
mod verdict;

pub use bent_law::{Along, Bend};
pub use detection_limit::DetectionLimit;
pub use diagnosis::{Cause, Diagnosis, Missing, Outlier, Outlook};
pub use failure::unsolvable;
pub use findings::doubt_sensors;
pub use free_law::{Apart, FreeLaw, Rival};
pub use laplace::weight;
pub use largest_change::LargestChange;
pub use next::Next;
pub use plan::{Alike, Plan, plan};
pub use posterior::{Believed, CERTAIN, Group, Posterior, RULED_OUT, speaks};
pub use residual_projection::ProjectedResidual;
pub use search::SIGNIFICANCE;
pub use under_noise::{UnderNoise, under_noise, under_stated_noise};
pub use verdict::{GoodnessOfFit, Verdict};

use std::cell::RefCell;

use crate::compare::Judges;
use crate::fit::{self, Objective};
use crate::model::{Data, Model};
use crate::noise::Noise;
use crate::process::{Description, Failure};
use crate::progress::Progress;
use explore::Exploration;
use hypothesis::Hypothesis;
use on_trial::values_on_trial;
use pool::NoiseChange;
use posterior::Visit;
use prior_conflict::Released;
use search::Extent;
use settle::look_until_settled;

/// Most effects that are sought together, unless told otherwise.
pub const MOST_EFFECTS: usize = 6;

/// Number of rows beyond which they are thinned: more rows tell causes apart no better than needed, and the
/// time of the search grows with them.
const MOST_ROWS: usize = 2000;

/// Searches for up to `most` effects of the catalogue that the model lacks.
///
/// # Errors
/// The data are too few, or the model cannot be computed.
pub fn diagnose(data: &Data, most: usize, progress: &Progress) -> Result<Diagnosis, Failure> {
    searched(data, (most, true), f64::INFINITY, progress)?.ok_or_else(unsolvable)
}

/// The same of a model with a law that was fitted to these data before: that of the best set is the deepest minimum. `None`
/// where the criterion of what is found is beyond `limit`, and nobody asks for the rest.
///
/// # Errors
/// As those of [`diagnose`].
pub fn diagnose_beside_law(
    data: &Data,
    most: usize,
    limit: f64,
    progress: &Progress,
) -> Result<Option<Diagnosis>, Failure> {
    searched(data, (most, false), limit, progress)
}

fn searched(
    data: &Data,
    (most, deepens): (usize, bool),
    limit: f64,
    progress: &Progress,
) -> Result<Option<Diagnosis>, Failure> {
    let some = thinned(data);
    let extent = Extent { most, deepens, known: &[], noise: NoiseChange::Terms, progress };
    // On a thread of the pool: one from outside would wait for it at every Jacobian.
    rayon::scope(|_| diagnose_all(some.as_ref().unwrap_or(data), limit, extent))
}

/// The rows that a diagnosis uses, where there are too many of them to use all.
pub fn thinned<'m>(data: &Data<'m>) -> Option<Data<'m>> {
    thinned_to(data, MOST_ROWS)
}

/// So many rows at most, repeats kept together, where there are more.
pub fn thinned_to<'m>(data: &Data<'m>, most: usize) -> Option<Data<'m>> {
    let every = data.len().div_ceil(most);
    (every > 1).then(|| {
        let keep = data.one_in(every, data.repeats());
        data.some(|row| keep[row])
    })
}

fn diagnose_all<'a>(data: &'a Data<'a>, limit: f64, extent: Extent<'_, 'a>) -> Result<Option<Diagnosis>, Failure> {
    let Extent { most, progress, .. } = extent;
    progress.expect(1);
    let repeats = data.repeats();
    let missing = absent(data.model);
    let changes = change::changes(data, &missing);
    let absent = [missing, instrument::absent_readings(data), values_on_trial(data.model), changes].concat();
    let absent: Vec<Description> = absent.into_iter().map(|effect| data.model.odds.put_on(effect)).collect();
    let mut objective = Objective::new(data)?;
    let mut solution = fit::best(&mut objective)?;
    let residuals = data.residuals(&solution.predicted);
    let mean = objective.mean(&solution).ok_or_else(unsolvable)?;
    let (noise, within) = Noise::stated(&data.terms, data, repeats, &residuals, &mean);
    objective.noise = noise;
    objective.coarseness = coarseness::coarseness(&objective, &solution, &absent);
    let mut found = look_until_settled(&mut objective, &mut solution, &absent, &within, extent)?;
    let mut released = Released::default();
    // Rows that do not tell their noise ask for no value against what is written.
    let judges = Judges::of(data, &found.base.residuals(), &objective.noise, &within);
    while judges == Judges::Both
        && let Some((parameter, conflict)) = prior_conflict::conflicting_prior(&found, &within)
    {
        if !progress.permits("the search with a value released that conflicts with what is written") {
            break;
        }
        released.held.get_or_insert_with(|| found.base.clone());
        objective.variables[parameter].prior = None;
        released.conflicts.push(conflict);
        let before = std::mem::take(&mut found.tried);
        let extent = Extent { known: &before, ..extent };
        found = look_until_settled(&mut objective, &mut solution, &absent, &within, extent)?;
    }
    let first = Hypothesis::new(found, within);
    let visits = RefCell::new(Visit::all(&first.found, &first.bent));
    let exploration = Exploration { start: &solution, absent: &absent, repeats, most, progress, visits: &visits };
    let hypotheses = progress.stretch("under which noise to search", || exploration.weigh(first))?;
    let posterior = Posterior::new(&visits.take());
    let conclude = || conclude::conclude(hypotheses, &released, posterior, limit);
    let diagnosis = progress.stretch("conclusion, intervals included", conclude);
    progress.advance(1);
    diagnosis
}

/// Effects of the process that the model does not have and that could act in it.
fn absent(model: &Model) -> Vec<Description> {
    let is_absent = |d: &Description| model.effects.iter().all(|e| e.description != *d);
    let own = |d: Description| Description { odds: model.system.odds(&d.name).unwrap_or(d.odds), ..d };
    let all = model.process.effects().into_iter().filter(is_absent);
    all.filter(|d| model.system.admits(&d.name).is_ok()).map(own).collect()
}
