//! What the model knows roughly and the data contradict. Held to a wrong value, a fit looks for causes that defend it.

use super::classes::EQUAL;
use super::search::Found;
use super::trial::Trial;
use super::verdict::{self, State};
use crate::fit::{self, Patience, minimise};
use crate::input::Parameter;
use crate::measure::Repeats;
use crate::units::Knowledge;

/// From so many of its standard uncertainties on a written value is doubted.
const FAR: f64 = 4.0;

/// A value that is known roughly and wrongly.
pub struct Contradiction {
    /// What is written, with its uncertainty.
    parameter: Parameter,
    /// What the data ask for, SI.
    asked: f64,
}

impl Contradiction {
    /// One sentence.
    pub fn text(&self) -> String {
        let (k, q) = (self.parameter.kind, &self.parameter.quantity);
        let std = match q.knowledge {
            Knowledge::Rough(std) => std / k.canonical().factor,
            Knowledge::Known | Knowledge::Free => 0.0,
        };
        let (written, asked) =
            (fit::uncertain(k.from_si(q.value), std), fit::uncertain(k.from_si(self.asked), 0.1 * std));
        format!(
            "{} is written as {written} {unit}, and the data ask for {asked}: it is taken as unknown here; check what is written",
            self.parameter.path,
            unit = k.unit
        )
    }
}

/// The parameter (by position) whose release brings the model down to the noise, and does it better than what the search found.
pub fn contradicted(found: &Found, repeats: &Repeats) -> Option<(usize, Contradiction)> {
    let best = found.best();
    let mut released: Vec<(usize, Trial)> = [&found.base, best]
        .into_iter()
        .flat_map(|trial| far(trial).into_iter().map(move |i| (trial, i)))
        .filter_map(|(trial, i)| Some((i, release(trial, i)?)))
        .collect();
    released.retain(|(_, trial)| {
        let state = State::of(trial, repeats, None);
        trial.score() < best.score() - EQUAL && verdict::is_noise(&state, &verdict::features(trial))
    });
    let (i, trial) = released.into_iter().min_by(|a, b| a.1.score().total_cmp(&b.1.score()))?;
    let axis = &trial.objective.axes[i];
    let parameter = trial.objective.parameters[i].clone();
    Some((i, Contradiction { parameter, asked: axis.value(trial.solution.position[i]) }))
}

/// The model's own parameters that a fit has moved far from what is written.
fn far(trial: &Trial) -> Vec<usize> {
    let is_far = |i: &usize| {
        let axis = &trial.objective.axes[*i];
        axis.prior.is_some_and(|(value, std)| (axis.value(trial.solution.position[*i]) - value).abs() > FAR * std)
    };
    (0..trial.objective.model.parameters.len()).filter(is_far).collect()
}

/// A trial that knows nothing of one parameter.
fn release<'a>(trial: &Trial<'a>, parameter: usize) -> Option<Trial<'a>> {
    let mut released = trial.clone();
    released.objective.axes[parameter].prior = None;
    released.solution = minimise(&mut released.objective, &trial.solution.position, &[], Patience::FULL)?;
    Some(released)
}
