//! Levenberg–Marquardt within bounds. Damping is scaled by the size of each column, a variable that pushes
//! against its bound stands still, and a step to where the model cannot be computed counts as too long.

use nalgebra::{DMatrix, DVector};

use super::objective::{Objective, Solution};
use crate::process::Failure;

/// Criterion by which a search for a minimum stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppingCriterion {
    /// Most steps.
    pub steps: usize,
    /// Fall of χ², as a part of 1 + χ², below which a step is the last.
    pub tolerance: f64,
}

impl StoppingCriterion {
    /// Full convergence.
    pub const FULL: Self = Self { steps: 60, tolerance: 1e-10 };
}

/// Finds the minimum near a position.
///
/// # Errors
/// The model cannot be computed there.
pub fn solve(objective: &mut Objective, start: &DVector<f64>) -> Result<Solution, Failure> {
    minimise(objective, start, &[], StoppingCriterion::FULL).ok_or_else(|| Failure {
        message: "the model cannot be computed where the fit begins".into(),
        help: "give the parameters values from which `fem run` works".into(),
    })
}

/// Minimises χ² from `start` with the variables `held` fixed; `None` where χ² cannot be computed at the
/// start.
pub fn minimise(
    objective: &mut Objective,
    start: &DVector<f64>,
    held: &[usize],
    stop: StoppingCriterion,
) -> Option<Solution> {
    let mut here = evaluate(objective, start.clone())?;
    let mut damping = 1e-3;
    for _ in 0..stop.steps {
        let Some(jacobian) = objective.jacobian(&here.position) else { break };
        let residuals = objective.residuals(&here.position, &here.predicted);
        let gradient = jacobian.transpose() * &residuals;
        let still = |i: usize| {
            let (variable, s) = (&objective.variables[i], here.position[i]);
            held.contains(&i) || (s <= variable.low && gradient[i] > 0.0) || (s >= variable.high && gradient[i] < 0.0)
        };
        let moving: Vec<usize> = (0..objective.variables.len()).filter(|i| !still(*i)).collect();
        if moving.is_empty() {
            break;
        }
        let Some((next, delta_chi2)) = descend(objective, &here, &jacobian, &gradient, &moving, &mut damping) else {
            break;
        };
        let settled = delta_chi2 <= stop.tolerance * (1.0 + here.chi2);
        here = next;
        if settled {
            break;
        }
    }
    Some(here)
}

fn evaluate(objective: &mut Objective, position: DVector<f64>) -> Option<Solution> {
    let predicted = objective.predict(&position)?;
    let chi2 = objective.residuals(&position, &predicted).norm_squared();
    Some(Solution { position, predicted, chi2 })
}

/// Finds the first damped step that lowers χ²; returns the new point and the fall of χ².
fn descend(
    objective: &mut Objective,
    here: &Solution,
    jacobian: &DMatrix<f64>,
    gradient: &DVector<f64>,
    moving: &[usize],
    damping: &mut f64,
) -> Option<(Solution, f64)> {
    let n = moving.len();
    let columns = DMatrix::from_fn(jacobian.nrows(), n, |r, c| jacobian[(r, moving[c])]);
    let normal = columns.transpose() * &columns;
    let downhill = DVector::from_fn(n, |i, _| -gradient[moving[i]]);
    for _ in 0..25 {
        let mut damped = normal.clone();
        for i in 0..n {
            damped[(i, i)] += *damping * normal[(i, i)].max(1e-30);
        }
        let step = damped.cholesky().map(|l| l.solve(&downhill));
        if let Some(step) = step {
            let mut position = here.position.clone();
            for (i, &moved) in moving.iter().enumerate() {
                let variable = &objective.variables[moved];
                position[moved] = (position[moved] + step[i]).clamp(variable.low, variable.high);
            }
            if let Some(next) = evaluate(objective, position).filter(|next| next.chi2 < here.chi2) {
                *damping = (*damping * 0.2).max(1e-12);
                let delta_chi2 = here.chi2 - next.chi2;
                return Some((next, delta_chi2));
            }
        }
        *damping *= 4.0;
    }
    None
}
