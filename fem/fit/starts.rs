//! Multistart: free nonlinear parameters are started from all over their plausible range, for χ² has many
//! valleys along a time constant or a place.

use nalgebra::DVector;

use super::least_squares::{StoppingCriterion, minimise};
use super::objective::{Objective, Solution};
use crate::process::Failure;

/// Most combinations of starts.
const MOST: usize = 240;
/// Stopping criterion of the first, short search from each start.
const SHORT: StoppingCriterion = StoppingCriterion::rough(12, 1e-10);

/// Finds the best minimum over all starts.
///
/// # Errors
/// The model cannot be computed at any of them.
pub fn best(objective: &mut Objective) -> Result<Solution, Failure> {
    settle_linear(objective);
    let mut tried: Vec<Solution> = Vec::new();
    for start in combinations(objective) {
        if let Some(solution) = minimise(objective, &start, &[], SHORT) {
            tried.push(solution);
        }
    }
    tried.sort_by(|a, b| a.chi2.total_cmp(&b.chi2));
    let finals: Vec<Solution> =
        tried.iter().take(3).filter_map(|s| minimise(objective, &s.position, &[], StoppingCriterion::FULL)).collect();
    let best = finals.into_iter().min_by(|a, b| a.chi2.total_cmp(&b.chi2)).ok_or_else(|| Failure {
        message: "the model cannot be computed anywhere that the fit begins".into(),
        help: "give the parameters values from which `fem run` works".into(),
    })?;
    Ok(between(objective, best))
}

/// Searches between the starts of parameters that have many: the place of a step has no slope to follow.
fn between(objective: &mut Objective, mut best: Solution) -> Solution {
    for i in
        (0..objective.variables.len()).filter(|i| objective.variables[*i].starts.len() > SEVERAL).collect::<Vec<_>>()
    {
        let starts = &objective.variables[i].starts;
        let (low, high) = starts.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(*s), h.max(*s)));
        let gap = (high - low) / starts.len() as f64 * 2.0;
        let middle = best.position[i];
        for k in -FINE..=FINE {
            let mut moved = best.position.clone();
            moved[i] = middle + gap * f64::from(k) / f64::from(FINE);
            let found = minimise(objective, &moved, &[i], SHORT);
            if let Some(found) = found.filter(|f| f.chi2 < best.chi2) {
                best = found;
            }
        }
    }
    best
}

/// Positions tried on either side.
const FINE: i32 = 24;

/// Keeps one start of each parameter in which the prediction is linear: one step finds it from anywhere, and
/// more starts are left to the others.
fn settle_linear(objective: &mut Objective) {
    let first = |a: &super::search_variable::SearchVariable| a.position(a.starts.first().copied().unwrap_or(1.0));
    let start = DVector::from_iterator(objective.variables.len(), objective.variables.iter().map(first));
    for i in
        (0..objective.variables.len()).filter(|i| objective.variables[*i].starts.len() > SEVERAL).collect::<Vec<_>>()
    {
        let mut at = |times: f64| {
            let mut moved = start.clone();
            moved[i] *= times;
            objective.predict(&moved).map(DVector::from_vec)
        };
        let (Some(one), Some(two), Some(three)) = (at(1.0), at(2.0), at(3.0)) else { continue };
        let (bend, change) = ((&three - &two * 2.0 + &one).norm(), (&three - &one).norm());
        if bend <= 1e-6 * change {
            objective.variables[i].starts.truncate(1);
        }
    }
}

/// Number of starts beyond which a parameter is sought everywhere.
const SEVERAL: usize = 10;

/// Makes every combination of the parameters' starts, or evenly spread ones where there are many.
fn combinations(objective: &Objective) -> Vec<DVector<f64>> {
    let variables = &objective.variables;
    let total = variables.iter().map(|a| a.starts.len()).fold(1usize, usize::saturating_mul);
    let count = total.min(MOST);
    let combination = |k: usize| {
        let mut number = if total == count { k } else { k * (total / count) + k % 5 };
        DVector::from_iterator(
            variables.len(),
            variables.iter().map(|a| {
                let start = a.starts[number % a.starts.len()];
                number /= a.starts.len();
                a.position(start)
            }),
        )
    };
    (0..count).map(combination).collect()
}
