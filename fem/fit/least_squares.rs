//! Levenberg–Marquardt inside bounds. Damping is by the size of each column, a variable that pushes against its bound stands still,
//! and a trial at which the model cannot be computed is a step too long.

use nalgebra::{DMatrix, DVector};

use super::objective::{Objective, Solution};
use crate::process::Failure;

/// When a search for a minimum ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Patience {
    /// Steps at most.
    pub steps: usize,
    /// A step that lowers χ² by less than this part of 1 + χ² is the last.
    pub fall: f64,
}

impl Patience {
    /// To the bottom.
    pub const FULL: Self = Self { steps: 60, fall: 1e-10 };
}

/// The minimum near a position.
///
/// # Errors
/// The model cannot be computed there.
pub fn solve(objective: &mut Objective, start: &DVector<f64>) -> Result<Solution, Failure> {
    minimise(objective, start, &[], Patience::FULL).ok_or_else(|| Failure {
        message: "the model cannot be computed where the fit begins".into(),
        help: "give the parameters values from which `fem run` works".into(),
    })
}

/// Minimises χ² from `start` with the variables `held` standing still; `None` where it cannot be computed at the start.
pub fn minimise(
    objective: &mut Objective,
    start: &DVector<f64>,
    held: &[usize],
    patience: Patience,
) -> Option<Solution> {
    let mut here = evaluate(objective, start.clone())?;
    let mut damping = 1e-3;
    for _ in 0..patience.steps {
        let Some(jacobian) = objective.jacobian(&here.position) else { break };
        let residuals = objective.residuals(&here.position, &here.predicted);
        let gradient = jacobian.transpose() * &residuals;
        let still = |i: usize| {
            let (axis, s) = (&objective.axes[i], here.position[i]);
            held.contains(&i) || (s <= axis.low && gradient[i] > 0.0) || (s >= axis.high && gradient[i] < 0.0)
        };
        let moving: Vec<usize> = (0..objective.axes.len()).filter(|i| !still(*i)).collect();
        if moving.is_empty() {
            break;
        }
        let Some((next, fall)) = descend(objective, &here, &jacobian, &gradient, &moving, &mut damping) else { break };
        let settled = fall <= patience.fall * (1.0 + here.chi2);
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

/// The first damped step that lowers χ², and by how much.
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
            for (i, &variable) in moving.iter().enumerate() {
                let axis = &objective.axes[variable];
                position[variable] = (position[variable] + step[i]).clamp(axis.low, axis.high);
            }
            if let Some(next) = evaluate(objective, position).filter(|next| next.chi2 < here.chi2) {
                *damping = (*damping * 0.2).max(1e-12);
                let fall = here.chi2 - next.chi2;
                return Some((next, fall));
            }
        }
        *damping *= 4.0;
    }
    None
}
