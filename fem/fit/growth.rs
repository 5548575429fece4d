//! A start for several effects of which nothing is known: they enter one after the other, each time the one that explains
//! the most, as a search for missing effects would find them. Values of all of them together, spread evenly, hardly ever
//! lie in the valley of the deepest minimum.

use nalgebra::DVector;
use rayon::prelude::*;

use super::least_squares::{StoppingCriterion, minimise};
use super::objective::{Objective, Solution};
use crate::process::Neutral;

/// Most combinations of the starts of one effect.
const MOST: usize = 25;
/// Part of its usual size with which an effect enters: at nothing its shape has no slope.
const SMALL: f64 = 0.1;
/// Stopping criterion while effects enter.
const SHORT: StoppingCriterion = StoppingCriterion::rough(12, 1e-6);

/// An effect of the model none of whose values are known.
struct Unknown {
    /// Variables that make it vanish.
    switches: Vec<usize>,
    /// Variables that shape it.
    shapes: Vec<usize>,
}

impl Unknown {
    fn has(&self, i: usize) -> bool {
        self.switches.contains(&i) || self.shapes.contains(&i)
    }

    /// Positions from which it may enter where the others stand.
    fn starts(&self, objective: &Objective, here: &DVector<f64>) -> Vec<DVector<f64>> {
        let variables = &objective.variables;
        let mut first = here.clone();
        for i in &self.switches {
            let own = &variables[*i];
            first[*i] = (own.neutral() + SMALL * own.unit).clamp(own.low, own.high);
        }
        let mut all = vec![first];
        for i in &self.shapes {
            let own = &variables[*i];
            let places: Vec<f64> = own.starts.iter().take((MOST / all.len()).max(1)).copied().collect();
            let at = |start: DVector<f64>| {
                places.iter().map(move |value| {
                    let mut start = start.clone();
                    start[*i] = own.position(*value);
                    start
                })
            };
            all = all.into_iter().flat_map(at).collect();
        }
        all
    }
}

/// The minimum to which the model's unknown effects lead one after the other; `None` where they are fewer than two or the
/// model cannot be computed.
pub fn grown(objective: &Objective) -> Option<Solution> {
    let mut left = unknown(objective);
    if left.len() < 2 {
        return None;
    }
    let variables = &objective.variables;
    let mut here = DVector::from_iterator(
        variables.len(),
        variables.iter().map(|own| own.position(own.starts.first().copied().unwrap_or(1.0))),
    );
    left.iter().flat_map(|own| &own.switches).for_each(|i| here[*i] = variables[*i].neutral());
    let mut best = None;
    while !left.is_empty() && objective.data.progress.permits("effects that enter a fit one after the other") {
        let trials: Vec<(usize, DVector<f64>)> = left
            .iter()
            .enumerate()
            .flat_map(|(number, own)| own.starts(objective, &here).into_iter().map(move |start| (number, start)))
            .collect();
        let held = |number: usize| -> Vec<usize> {
            let is_held = |i: &usize| left.iter().enumerate().any(|(other, own)| other != number && own.has(*i));
            (0..variables.len()).filter(is_held).collect()
        };
        let fitted = |(number, start): (usize, DVector<f64>)| {
            Some((number, minimise(&mut objective.clone(), &start, &held(number), SHORT)?))
        };
        let fits: Vec<(usize, Solution)> = trials.into_par_iter().filter_map(fitted).collect();
        let (number, solution) = fits.into_iter().min_by(|a, b| a.1.chi2.total_cmp(&b.1.chi2))?;
        left.remove(number);
        here.copy_from(&solution.position);
        best = Some(solution);
    }
    best.filter(|_| left.is_empty())
}

/// Effects of the catalogue none of whose values are known, and which can vanish.
fn unknown(objective: &Objective) -> Vec<Unknown> {
    let model = objective.data.model;
    let mut all: Vec<(&str, Vec<usize>)> = Vec::new();
    for (i, parameter) in objective.parameters.iter().enumerate() {
        let Some(effect) = model.effect_of(&parameter.path).filter(|_| objective.catalogue(i).is_some()) else {
            continue;
        };
        match all.iter_mut().find(|(name, _)| *name == effect) {
            Some((_, own)) => own.push(i),
            None => all.push((effect, vec![i])),
        }
    }
    let is_free =
        |i: &usize| objective.variables[*i].prior.is_none() && objective.parameters[*i].quantity.value.is_nan();
    let is_shape = |i: &usize| objective.catalogue(*i).is_some_and(|entry| entry.neutral == Neutral::Shape);
    let unknown = |(_, own): (&str, Vec<usize>)| {
        let is_unknown = own.iter().all(is_free);
        let (shapes, switches): (Vec<usize>, Vec<usize>) = own.into_iter().partition(is_shape);
        (is_unknown && !switches.is_empty()).then_some(Unknown { switches, shapes })
    };
    all.into_iter().filter_map(unknown).collect()
}
