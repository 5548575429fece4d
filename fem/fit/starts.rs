//! Multistart: free nonlinear parameters are started from all over their plausible range, for χ² has many
//! valleys along a time constant or a place.

use nalgebra::DVector;

use super::growth::grown;
use super::least_squares::{StoppingCriterion, minimise};
use super::objective::{Objective, Solution};
use crate::compare::SIGNIFICANCE;
use crate::noise::beyond_chi2;
use crate::process::Failure;
use crate::units::{Knowledge, Quantity};

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
        if !tried.is_empty() && !objective.data.progress.permits("further places from which the fit could begin") {
            break;
        }
        let start = beside_what_is_told(objective, start);
        if let Some(solution) = minimise(objective, &start, &[], SHORT) {
            tried.push(solution);
        }
    }
    tried.sort_by(|a, b| a.chi2.total_cmp(&b.chi2));
    let finals: Vec<Solution> =
        tried.iter().take(3).filter_map(|s| minimise(objective, &s.position, &[], StoppingCriterion::FULL)).collect();
    let deepest = |found: Vec<Solution>| found.into_iter().min_by(|a, b| a.chi2.total_cmp(&b.chi2));
    let mut best = deepest(finals);
    if best.as_ref().is_none_or(|best| !is_explained(objective, best)) {
        let grown = grown(objective).and_then(|from| minimise(objective, &from.position, &[], StoppingCriterion::FULL));
        best = deepest(best.into_iter().chain(grown).collect());
    }
    let best = best.ok_or_else(|| Failure {
        message: "the model cannot be computed anywhere that the fit begins".into(),
        help: "give the parameters values from which `fem run` works".into(),
    })?;
    let best = between(objective, best);
    Ok(survey(objective, best))
}

/// A start from which everything else has come to meet those unknowns of which it is told where they are near: as long as an
/// offset is far off, a law would run from where it is known to be only to make good for it.
fn beside_what_is_told(objective: &mut Objective, start: DVector<f64>) -> DVector<f64> {
    let is_told = |i: &usize| {
        let Quantity { value, knowledge } = objective.parameters[*i].quantity;
        knowledge == Knowledge::Free && !value.is_nan()
    };
    let told: Vec<usize> = (0..objective.parameters.len()).filter(is_told).collect();
    if told.is_empty() || told.len() == objective.variables.len() {
        return start;
    }
    minimise(objective, &start, &told, SHORT).map_or(start, |met| met.position)
}

/// Ratio either way within which an unknown of the set-up is surveyed, and places on either side: near enough
/// for valleys a thirtieth of the value apart, such as the turns of a screw along a path.
const SURVEYED: f64 = 1.4;
const PLACES: i32 = 32;
/// Valleys of a survey from which a search begins, and surveys one after the other.
const VALLEYS: usize = 3;
const SURVEYS: usize = 6;

/// Stopping criterion of a place of a survey.
const ROUGH: StoppingCriterion = StoppingCriterion::rough(3, 1e-3);

/// Looks for deeper minima along unknowns of the set-up, unless the noise is known and explains what is left.
fn survey(objective: &mut Objective, mut best: Solution) -> Solution {
    for i in (0..objective.variables.len()).filter(|i| objective.variables[*i].is_surveyed).collect::<Vec<_>>() {
        for _ in 0..SURVEYS {
            if is_explained(objective, &best) || !objective.data.progress.permits("the survey for deeper minima") {
                return best;
            }
            let starts = valleys(objective, &best, i);
            let tried = starts.iter().filter_map(|start| minimise(objective, start, &[], SHORT)).collect::<Vec<_>>();
            let deepest = tried.into_iter().min_by(|a, b| a.chi2.total_cmp(&b.chi2));
            let Some(deeper) = deepest.filter(|found| found.chi2 < best.chi2 * (1.0 - 1e-6)) else { break };
            best = minimise(objective, &deeper.position, &[], StoppingCriterion::FULL).unwrap_or(deeper);
        }
    }
    best
}

fn is_explained(objective: &Objective, best: &Solution) -> bool {
    let p_value = || beyond_chi2(objective.freedom(), best.chi2);
    objective.noise.source.is_known() && p_value().is_some_and(|p| p >= SIGNIFICANCE)
}

/// The deepest valleys of χ² along one variable, the others held where they are, but of a formula, which costs little,
/// fitted: a law that stands in the wrong place is none; not the one of `best`.
fn valleys(objective: &mut Objective, best: &Solution, i: usize) -> Vec<DVector<f64>> {
    let value = objective.variables[i].value(best.position[i]);
    let is_of_formula = objective.data.model.is_of_formula(&objective.parameters[i].path);
    let mut at = |k: i32| {
        let mut moved = best.position.clone();
        moved[i] = objective.variables[i].position(value * SURVEYED.powf(f64::from(k) / f64::from(PLACES)));
        if is_of_formula {
            let found = minimise(objective, &moved, &[i], ROUGH);
            return found.map_or((f64::INFINITY, moved), |found| (found.chi2, found.position));
        }
        let chi2 = objective.predict(&moved).map(|p| objective.residuals(&moved, &p).norm_squared());
        (chi2.unwrap_or(f64::INFINITY), moved)
    };
    let all: Vec<(f64, DVector<f64>)> = (-PLACES..=PLACES).map(&mut at).collect();
    let is_valley = |k: &usize| {
        let beside = [k.checked_sub(1), Some(k + 1)].map(|n| n.and_then(|n| all.get(n)).map_or(f64::INFINITY, |a| a.0));
        *k != PLACES as usize && all[*k].0.is_finite() && beside.iter().all(|b| all[*k].0 <= *b)
    };
    let mut found: Vec<usize> = (0..all.len()).filter(is_valley).collect();
    found.sort_by(|a, b| all[*a].0.total_cmp(&all[*b].0));
    found.into_iter().take(VALLEYS).map(|k| all[k].1.clone()).collect()
}

/// Searches between the starts of parameters that have many: the place of a step has no slope to follow.
fn between(objective: &mut Objective, mut best: Solution) -> Solution {
    for i in (0..objective.variables.len()).filter(|i| is_sought(objective, *i)).collect::<Vec<_>>() {
        let starts = &objective.variables[i].starts;
        let (low, high) = starts.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), s| (l.min(*s), h.max(*s)));
        let gap = (high - low) / starts.len() as f64 * 2.0;
        let middle = best.position[i];
        for k in -FINE..=FINE {
            if !objective.data.progress.permits("places between those from which the fit began") {
                return best;
            }
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
    for i in (0..objective.variables.len()).filter(|i| is_sought(objective, *i)).collect::<Vec<_>>() {
        let at = |times: f64| {
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

/// Whether a parameter is sought everywhere: one that stands at certain places alone begins at each of them.
fn is_sought(objective: &Objective, i: usize) -> bool {
    let variable = &objective.variables[i];
    variable.starts.len() > SEVERAL && variable.steps.is_none()
}

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
