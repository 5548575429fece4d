//! The error on what was not fitted: one part, run or condition at a time is left out, and predicted from the others.

use nalgebra::{DMatrix, DVector};

use super::trial::Trial;
use crate::process::Holds;

/// Groups that are left out, at most.
const FOLDS: usize = 12;

/// What was left out in turn: its name, and the group of each row.
pub struct Folds {
    /// `part`, `run`, `direction`, or the first coordinate.
    pub coordinate: &'static str,
    group: Vec<usize>,
    count: usize,
}

impl Folds {
    /// By runs that repeat each other; else by the first number of a part or set-up that varies, by words (a direction, which as a rule the
    /// others cannot predict), or by stretches of the first coordinate. `None` where nothing varies.
    pub fn of(trial: &Trial) -> Option<Self> {
        let measurements = trial.objective.measurements;
        let coordinates = trial.objective.model.process.coordinates();
        let varies = |i: &usize| {
            let column = &measurements.rows.columns[*i];
            measurements.given.contains(i) && column.iter().any(|v| *v != column[0])
        };
        let rank = |i: &usize| match coordinates[*i].holds {
            _ if coordinates[*i].repeats => 0,
            Holds::Number(_) => 1,
            Holds::Word(_) => 2,
            Holds::Quantity(_) => 3,
        };
        let chosen = (0..coordinates.len()).filter(varies).min_by_key(rank)?;
        let column = &measurements.rows.columns[chosen];
        let mut levels = column.clone();
        levels.sort_unstable_by(f64::total_cmp);
        levels.dedup();
        let count = levels.len().min(FOLDS);
        let group = |v: &f64| levels.partition_point(|l| l < v) * count / levels.len();
        let group = column.iter().map(group).collect();
        Some(Self { coordinate: coordinates[chosen].name, group, count })
    }

    /// Root mean square of the held-out residuals, in standard uncertainties of the rows. To first order about the fit of all rows:
    /// r_out = (1 − H)⁻¹·r with the block H of the hat matrix (Cook and Weisberg 1982), exact where the model is linear.
    pub fn error(&self, trial: &Trial) -> Option<f64> {
        let mut objective = trial.objective.clone();
        let jacobian = objective.jacobian(&trial.solution.position)?;
        let residuals = objective.residuals(&trial.solution.position, &trial.solution.predicted);
        let covariance = objective.covariance(&trial.solution).ok()?;
        let mut square = 0.0;
        for fold in 0..self.count {
            let rows: Vec<usize> = (0..self.group.len()).filter(|r| self.group[*r] == fold).collect();
            let part = jacobian.select_rows(&rows);
            let own = DVector::from_iterator(rows.len(), rows.iter().map(|r| residuals[*r]));
            let out = held_out(&part, &covariance, own)?;
            square += out.norm_squared();
        }
        Some((square / self.group.len() as f64).sqrt())
    }
}

/// Less than this part of what all rows say of some parameters is said by those that stay: they do not tell it.
const UNTOLD: f64 = 1e-7;
/// Of an iteration that needs a few; what is no number has no end.
const ROUNDS: usize = 1000;

/// (1 − J·C·Jᵀ)⁻¹·r by Woodbury, with a system of the size of the parameters: r + J·(C⁻¹ − JᵀJ)⁻¹·Jᵀ·r. `None` where the rows that stay
/// leave a parameter open.
fn held_out(jacobian: &DMatrix<f64>, covariance: &DMatrix<f64>, own: DVector<f64>) -> Option<DVector<f64>> {
    if covariance.is_empty() {
        return Some(own);
    }
    let n = covariance.nrows();
    // (C⁻¹ − JᵀJ)⁻¹ = (1 − C·JᵀJ)⁻¹·C keeps what the data do not see out of an inverse.
    let inner = DMatrix::identity(n, n) - covariance * (jacobian.transpose() * jacobian);
    // In units of each parameter's own uncertainty, so that sizes can be compared.
    let scale = covariance.diagonal().map(f64::sqrt);
    let scaled = DMatrix::from_fn(n, n, |i, j| inner[(i, j)] * scale[j] / scale[i]);
    let least = scaled.try_svd(false, false, f64::EPSILON, ROUNDS).map(|svd| svd.singular_values.min());
    if least.is_none_or(|least| least < UNTOLD) {
        return None;
    }
    let right = covariance * (jacobian.transpose() * &own);
    inner.lu().solve(&right).map(|v| own + jacobian * v)
}
