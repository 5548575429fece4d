//! From a minimum to a lower one at neighbouring places of parameters in which the law is a step.

use nalgebra::DVector;

use super::objective::{Objective, Solution};

/// Most moves from place to place in one search.
const MOVES: usize = 16;

/// Goes from a minimum to neighbouring places of such parameters as long as χ² falls there; `descend` finds the minimum
/// from a point with a lower χ².
pub fn settle(
    objective: &mut Objective,
    mut here: Solution,
    held: &[usize],
    mut descend: impl FnMut(&mut Objective, Solution) -> Solution,
) -> Solution {
    for _ in 0..MOVES {
        let Some(lower) = lower_beside(objective, &here, held) else { break };
        here = descend(objective, lower);
    }
    here
}

/// The lowest point beside one, at the widest move that falls.
fn lower_beside(objective: &Objective, here: &Solution, held: &[usize]) -> Option<Solution> {
    let stepping = |i: &usize| !held.contains(i) && objective.variables[*i].steps.is_some();
    for i in (0..objective.variables.len()).filter(stepping) {
        let steps = objective.variables[i].steps.as_ref()?;
        let mut stride = steps.stride() as isize;
        while stride > 0 {
            let at = |by: isize| moved(objective, here, i, steps.beside(here.position[i], by)?);
            let lowest = [-stride, stride].into_iter().filter_map(at).min_by(|a, b| a.chi2.total_cmp(&b.chi2));
            if let Some(lower) = lowest.filter(|there| there.chi2 < here.chi2) {
                return Some(lower);
            }
            stride /= 2;
        }
    }
    None
}

/// The point with one variable elsewhere.
fn moved(objective: &Objective, here: &Solution, i: usize, to: f64) -> Option<Solution> {
    let mut position: DVector<f64> = here.position.clone();
    position[i] = to;
    objective.evaluate(position)
}
