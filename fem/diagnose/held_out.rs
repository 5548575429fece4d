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
    /// By the first label that varies; else by stretches of the first coordinate. `None` where nothing varies.
    pub fn of(trial: &Trial) -> Option<Self> {
        let measurements = trial.objective.measurements;
        let coordinates = trial.objective.model.process.coordinates();
        let varies = |i: &usize| {
            let column = &measurements.rows.columns[*i];
            measurements.given.contains(i) && column.iter().any(|v| *v != column[0])
        };
        let label = |i: &usize| !matches!(coordinates[*i].holds, Holds::Quantity(_));
        let varying: Vec<usize> = (0..coordinates.len()).filter(varies).collect();
        let chosen = varying.iter().copied().find(label).or_else(|| varying.first().copied())?;
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

/// (1 − J·C·Jᵀ)⁻¹·r by Woodbury, with a system of the size of the parameters: r + J·(C⁻¹ − JᵀJ)⁻¹·Jᵀ·r.
fn held_out(jacobian: &DMatrix<f64>, covariance: &DMatrix<f64>, own: DVector<f64>) -> Option<DVector<f64>> {
    if covariance.is_empty() {
        return Some(own);
    }
    let n = covariance.nrows();
    // (C⁻¹ − JᵀJ)⁻¹ = (1 − C·JᵀJ)⁻¹·C keeps what the data do not see out of an inverse.
    let inner = DMatrix::identity(n, n) - covariance * (jacobian.transpose() * jacobian);
    let right = covariance * (jacobian.transpose() * &own);
    inner.lu().solve(&right).map(|v| own + jacobian * v)
}
