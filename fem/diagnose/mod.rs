//! Which effect is missing: the search over everything that the process knows and the model does not have.
//!
//! The model's own freedom is re-fitted together with every effect on trial, sets of effects grow while the gain is more than chance gives to a
//! search as wide, and what fits as well is named beside what is found. What no effect explains is described, not explained.

mod classes;
mod conclude;
mod contradiction;
mod gain;
mod ground;
mod held_out;
mod next;
mod pairs;
mod plan;
mod price;
mod search;
mod signature;
mod trial;
mod verdict;
mod visibility;

pub use next::Next;
pub use plan::{Alike, Plan, plan, programme};
pub use search::SIGNIFICANCE;
pub use verdict::{State, Verdict};
pub use visibility::Visibility;

use crate::compare::{Feature, Level, Noise, NoiseSource};
use crate::fit::{self, Estimate, Fit, Objective, Patience, Solution, minimise};
use crate::measure::{Measurements, Repeats, repeats};
use crate::model::Model;
use crate::process::{Description, Failure};
use crate::progress::Progress;
use price::Yardstick;
use search::{Breadth, Found};
use trial::Trial;

/// Effects that are looked for together, unless told otherwise.
pub const MOST_EFFECTS: usize = 3;
/// The noise is estimated anew when what the best set leaves differs by more than this ratio.
const SETTLED: f64 = 1.1;

/// What is missing in a model. SI units.
pub struct Diagnosis {
    /// Rows that were used; all of them unless there are very many.
    pub rows: usize,
    /// What should be known of the data before the rest is believed.
    pub cautions: Vec<String>,
    /// The noise that everything was judged by.
    pub noise: Level,
    /// The model with its own freedom re-fitted.
    pub before: State,
    /// Where that fails.
    pub features: Vec<Feature>,
    /// In a word.
    pub verdict: Verdict,
    /// The effects, in the order in which they should be added.
    pub missing: Vec<Missing>,
    /// The model with all of them.
    pub after: State,
    /// All parameters of that, the model's own and those of the effects.
    pub fit: Fit,
    /// Structure that remains.
    pub remaining: Vec<Feature>,
    /// Every effect that the model does not have.
    pub candidates: Vec<Outlook>,
    /// What to measure next, where effects cannot be told apart.
    pub next: Option<Next>,
    /// By which coordinate rows were held out.
    pub held_out_by: Option<&'static str>,
    /// Trial values at which the model could not be computed, and all of them.
    pub trials: (usize, usize),
}

/// An effect that is missing.
pub struct Missing {
    /// Which.
    pub effect: &'static Description,
    /// The model with this and the effects before it.
    pub state: State,
    /// How often chance alone gains as much by any effect, all others being there.
    pub p_value: f64,
    /// Its parameters, fitted with all others.
    pub estimates: Vec<Estimate>,
    /// Effects that fit as well in its place.
    pub indistinguishable_from: Vec<&'static Description>,
}

/// What the data say of one effect that the model does not have.
pub struct Outlook {
    /// Which.
    pub effect: &'static Description,
    /// With this effect alone added; `None` where it gains nothing or cannot be computed.
    pub rms: Option<f64>,
    /// Change of Schwarz's criterion by it alone; below zero speaks for it.
    pub delta_bic: f64,
    /// How often chance alone gains as much by any effect.
    pub p_value: f64,
    /// What could have been seen of it.
    pub visibility: Option<Visibility>,
}

/// More rows than this are thinned, whole groups of repeats together: they tell causes apart no better than needed, and the search takes its time from them.
const MOST_ROWS: usize = 2000;

/// Looks for up to `most` effects that the model lacks.
///
/// # Errors
/// The data are too few, or the model cannot be computed.
pub fn diagnose(
    model: &Model,
    measurements: &Measurements,
    most: usize,
    progress: &Progress,
) -> Result<Diagnosis, Failure> {
    let all = repeats(measurements, model.process.coordinates());
    let every = measurements.len().div_ceil(MOST_ROWS);
    if every > 1 {
        let some = measurements.some(|row| all.group[row].is_multiple_of(every));
        let repeats = repeats(&some, model.process.coordinates());
        return diagnose_all(model, &some, &repeats, most, progress);
    }
    diagnose_all(model, measurements, &all, most, progress)
}

fn diagnose_all(
    model: &Model,
    measurements: &Measurements,
    repeats: &Repeats,
    most: usize,
    progress: &Progress,
) -> Result<Diagnosis, Failure> {
    progress.expect(1);
    let measurements = &*measurements.seen_by(&*model.system);
    let absent = absent(model);
    let mut objective = Objective::new(model, measurements)?;
    let mut solution = fit::best(&mut objective)?;
    let residuals: Vec<f64> = measurements.observed.iter().zip(&solution.predicted).map(|(y, p)| y - p).collect();
    objective.noise = Noise::of(measurements, repeats, &residuals);
    let mut found = look_until_settled(&mut objective, &mut solution, &absent, repeats, (most, progress))?;
    let mut contradictions = Vec::new();
    while let Some((parameter, contradiction)) = contradiction::contradicted(&found, repeats) {
        objective.axes[parameter].prior = None;
        contradictions.push(contradiction);
        found = look_until_settled(&mut objective, &mut solution, &absent, repeats, (most, progress))?;
    }
    let diagnosis = conclude::conclude(found, repeats, &contradictions);
    progress.advance(1);
    diagnosis
}

/// One search after the other, until what the best set leaves is the noise that it was found with.
fn look_until_settled<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[&'static Description],
    repeats: &Repeats,
    (most, progress): (usize, &Progress),
) -> Result<Found<'a>, Failure> {
    /// Searches after the first.
    const MOST: usize = 4;
    let mut found = look(objective, solution, absent, repeats, (most, progress))?;
    if objective.noise.source == NoiseSource::Estimated {
        for _ in 0..MOST {
            let left = found.best().objective.left_over(&found.best().solution);
            let settled = left.is_about(&objective.noise, SETTLED);
            objective.noise = left;
            found = look(objective, solution, absent, repeats, (most, progress))?;
            if settled {
                break;
            }
        }
    }
    Ok(found)
}

/// The effects of the process that the model does not have and that could act in it.
fn absent(model: &Model) -> Vec<&'static Description> {
    let is_absent = |d: &&'static Description| model.effects.iter().all(|e| e.description != *d);
    model.process.effects().into_iter().filter(is_absent).filter(|d| model.system.admits(d.name).is_ok()).collect()
}

/// One search with a given noise.
fn look<'a>(
    objective: &mut Objective<'a>,
    solution: &mut Solution,
    absent: &[&'static Description],
    repeats: &Repeats,
    (most, progress): (usize, &Progress),
) -> Result<Found<'a>, Failure> {
    *solution = minimise(objective, &solution.position, &[], Patience::FULL).ok_or_else(unsolvable)?;
    let candidates = signature::candidates(objective, solution, absent);
    let base = Trial { members: Vec::new(), objective: objective.clone(), solution: solution.clone() };
    let yardstick = yardstick(&objective.noise, repeats);
    let mut found = search::search(base.clone(), candidates.clone(), yardstick, (most, Breadth::USUAL), progress)
        .ok_or_else(unsolvable)?;
    let explains = |best: &Trial| {
        let state = State::of(best, repeats, None);
        best.members.is_empty() || verdict::is_noise(&state, &verdict::features(best))
    };
    if explains(found.best()) {
        return Ok(found);
    }
    if let Some(best) = found.steps.last_mut() {
        // It may stand in a shallow minimum.
        best.solution = fit::settle(&mut best.objective, best.solution.clone())?.solution;
        if explains(best) {
            return Ok(found);
        }
    }
    search::search(base, candidates, yardstick, (most, Breadth::WIDE), progress).ok_or_else(unsolvable)
}

fn yardstick(noise: &Noise, repeats: &Repeats) -> Yardstick {
    match noise.source {
        NoiseSource::Column => Yardstick::Known,
        NoiseSource::Repeats => Yardstick::Repeats(repeats.yardstick()),
        NoiseSource::Estimated => Yardstick::LeftOver,
    }
}

fn unsolvable() -> Failure {
    Failure {
        message: "the model cannot be computed about its best values".into(),
        help: "give the parameters values from which `fem run` works".into(),
    }
}
