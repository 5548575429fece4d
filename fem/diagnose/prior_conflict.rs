//! Prior conflicts: values that the model knows roughly and the data contradict. A fit that is held to a
//! wrong value finds causes that defend it.

use super::candidate_model::CandidateModel;
use super::confounding::EQUAL_FIT;
use super::search::SearchResult;
use super::verdict::is_explained;
use crate::fit::{self, StoppingCriterion, minimise};
use crate::input::Parameter;
use crate::measure::Repeats;
use crate::process::is_size;
use crate::units::Knowledge;

/// Prior standard uncertainties beyond which a written value is doubted.
const FAR: f64 = 4.0;

/// Values that are taken as unknown because the data contradict what is written, and the model as it is written.
#[derive(Default)]
pub struct Released<'a> {
    /// What conflicts.
    pub conflicts: Vec<PriorConflict>,
    /// The model without candidate effects, held to all that is written; `None` where nothing conflicts.
    pub held: Option<CandidateModel<'a>>,
}

/// Prior that conflicts with the data.
pub struct PriorConflict {
    /// Parameter with its written value and uncertainty.
    pub parameter: Parameter,
    /// Value that the data ask for, SI.
    asked: f64,
}

impl PriorConflict {
    /// Caution in one sentence.
    pub fn text(&self) -> String {
        let (k, q) = (self.parameter.kind, &self.parameter.quantity);
        let std = match q.knowledge {
            Knowledge::Rough(std) => std / k.canonical().factor,
            Knowledge::Known | Knowledge::Free => 0.0,
        };
        let (written, asked) = (fit::uncertain(k.from_si(q.value), std), fit::five_digits(k.from_si(self.asked)));
        format!(
            "{} is written as {written} {unit}, and the data ask for {asked} {unit}: it is taken as unknown here; check what is written",
            self.parameter.path,
            unit = k.unit
        )
    }
}

/// Finds the parameter (by position) without whose prior the model fits down to the noise, and better than
/// with the effects that the search found, or as well where those are two more or of a size that is not plausible.
pub fn conflicting_prior(found: &SearchResult, repeats: &Repeats) -> Option<(usize, PriorConflict)> {
    let best = found.best();
    let mut released: Vec<(usize, CandidateModel)> = [&found.base, best]
        .into_iter()
        .flat_map(|trial| far(trial).into_iter().map(move |i| (trial, i)))
        .filter_map(|(trial, i)| Some((i, release(trial, i)?)))
        .collect();
    // One number that is written wrongly is likelier than two causes that make up for it.
    let is_strained = is_strained(best);
    let margin = |trial: &CandidateModel| match best.members.len() + usize::from(is_strained) > trial.members.len() + 1
    {
        true => EQUAL_FIT,
        false => -EQUAL_FIT,
    };
    let is_better = |trial: &CandidateModel| trial.bic() < best.bic() + margin(trial);
    released.retain(|(_, trial)| is_better(trial) && is_explained(trial, repeats));
    let (i, trial) = released.into_iter().min_by(|a, b| a.1.bic().total_cmp(&b.1.bic()))?;
    let variable = &trial.objective.variables[i];
    let parameter = trial.objective.parameters[i].clone();
    Some((i, PriorConflict { parameter, asked: variable.value(trial.solution.position[i]) }))
}

/// Whether an effect of a set has a size that is not plausible.
fn is_strained(set: &CandidateModel) -> bool {
    let mut own = set.objective.data.model.parameters.len()..set.objective.variables.len();
    let value = |i: usize| set.objective.variables[i].value(set.solution.position[i]);
    own.any(|i| set.objective.catalogue(i).is_some_and(|entry| is_size(entry) && !entry.is_plausible(value(i))))
}

/// Model's own parameters that a fit has moved far from their priors.
fn far(trial: &CandidateModel) -> Vec<usize> {
    let is_far = |i: &usize| {
        let variable = &trial.objective.variables[*i];
        variable
            .prior
            .is_some_and(|(value, std)| (variable.value(trial.solution.position[*i]) - value).abs() > FAR * std)
    };
    (0..trial.objective.data.model.parameters.len()).filter(is_far).collect()
}

/// Fits a candidate model without the prior of one parameter.
fn release<'a>(trial: &CandidateModel<'a>, parameter: usize) -> Option<CandidateModel<'a>> {
    let mut released = trial.clone();
    released.objective.variables[parameter].prior = None;
    released.solution = minimise(&mut released.objective, &trial.solution.position, &[], StoppingCriterion::FULL)?;
    Some(released)
}
