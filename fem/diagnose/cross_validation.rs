//! Cross-validation: one part, run or condition at a time is left out, and predicted from the others.

use nalgebra::{DMatrix, DVector};

use super::candidate_model::CandidateModel;
use crate::input::Name;
use crate::model::Data;
use crate::process::Holds;

/// Most folds.
const FOLDS: usize = 12;

/// Folds of the cross-validation: the coordinate by which rows are grouped, and the fold of each row.
pub struct Folds {
    /// Name of the coordinate: `part`, `run`, `direction`, or the first coordinate.
    pub coordinate: Name,
    group: Vec<usize>,
    count: usize,
}

impl Folds {
    /// Folds by runs that repeat each other; else by the first number of a part or set-up that varies, by
    /// words (a direction, which as a rule the others cannot predict), or by stretches of the first
    /// coordinate. `None` where nothing varies.
    pub fn of(trial: &CandidateModel) -> Option<Self> {
        let coordinates = trial.objective.data.model.process.coordinates();
        let rank = |i: &usize| match coordinates[*i].holds {
            _ if coordinates[*i].repeats => 0,
            _ if coordinates[*i].is_recorded => 4,
            Holds::Number(_) => 1,
            Holds::Word(_) => 2,
            Holds::Quantity(_) => 3,
        };
        let chosen = varying(trial.objective.data).min_by_key(rank)?;
        Some(Self::by(trial.objective.data, chosen))
    }

    /// Folds by every number and every quantity that varies: parts and runs, targets, sensors, conditions and
    /// times.
    pub fn every(trial: &CandidateModel) -> Vec<Self> {
        let data = trial.objective.data;
        let coordinates = data.model.process.coordinates();
        let is_word = |i: usize| matches!(coordinates[i].holds, Holds::Word(_));
        varying(data).filter(|i| !is_word(*i)).map(|i| Self::by(data, i)).filter(|folds| folds.count > 2).collect()
    }

    fn by(data: &Data, coordinate: usize) -> Self {
        let column = &data.rows.columns[coordinate];
        let mut levels: Vec<f64> = column.iter().copied().filter(|v| !v.is_nan()).collect();
        levels.sort_unstable_by(f64::total_cmp);
        levels.dedup();
        let count = levels.len().min(FOLDS);
        // Rows that have no such coordinate are in no fold: they stay when others are held out.
        let group = |v: &f64| match v.is_nan() {
            true => count,
            false => levels.partition_point(|l| l < v) * count / levels.len(),
        };
        let group = column.iter().map(group).collect();
        Self { coordinate: data.model.process.coordinates()[coordinate].name.clone(), group, count }
    }

    /// Whether the others can tell of a group what it is like: a direction is, as a rule, told by itself alone.
    pub fn can_be_told(&self, data: &Data) -> bool {
        let own = data.model.process.coordinates().iter().find(|own| own.name == self.coordinate);
        self.count > 2 && own.is_some_and(|own| !matches!(own.holds, Holds::Word(_)))
    }

    /// Root mean square of the held-out residuals, in standard uncertainties of the rows, to first order
    /// about the fit of all rows: r_out = (1 − H)⁻¹·r with the block H of the hat matrix (Cook and Weisberg
    /// 1982), exact where the model is linear.
    pub fn error(&self, trial: &CandidateModel) -> Option<f64> {
        let objective = trial.objective.clone();
        let jacobian = objective.jacobian(&trial.solution)?;
        let residuals = objective.residuals(&trial.solution.position, &trial.solution.predicted);
        let covariance = objective.covariance(&jacobian);
        let (mut square, mut count) = (0.0, 0);
        for fold in 0..self.count {
            let rows: Vec<usize> = (0..self.group.len()).filter(|r| self.group[*r] == fold).collect();
            let part = jacobian.select_rows(&rows);
            let own = DVector::from_iterator(rows.len(), rows.iter().map(|r| residuals[*r]));
            let out = cross_validation(&part, &covariance, own)?;
            square += out.norm_squared();
            count += rows.len();
        }
        Some((square / count as f64).sqrt())
    }
}

/// Coordinates of the file that vary.
fn varying<'d>(data: &'d Data) -> impl Iterator<Item = usize> + 'd {
    let varies = |i: &usize| {
        let column = &data.rows.columns[*i];
        data.given.contains(i) && column.iter().any(|v| *v != column[0])
    };
    (0..data.rows.columns.len()).filter(varies)
}

/// Part of the information of all rows on a parameter below which the rows that stay do not determine it.
const UNTOLD: f64 = 1e-7;
/// Most rounds of an iteration that needs a few; on NaN it would not end.
const ROUNDS: usize = 1000;

/// Held-out residuals (1 − J·C·Jᵀ)⁻¹·r by Woodbury's identity, with a system of the size of the parameters:
/// r + J·(C⁻¹ − JᵀJ)⁻¹·Jᵀ·r. `None` where the rows that stay leave a parameter open.
fn cross_validation(jacobian: &DMatrix<f64>, covariance: &DMatrix<f64>, own: DVector<f64>) -> Option<DVector<f64>> {
    if covariance.is_empty() {
        return Some(own);
    }
    let n = covariance.nrows();
    // (C⁻¹ − JᵀJ)⁻¹ = (1 − C·JᵀJ)⁻¹·C needs no inverse of directions that the data do not see.
    let inner = DMatrix::identity(n, n) - covariance * (jacobian.transpose() * jacobian);
    // Scaled by each parameter's own uncertainty, so that sizes can be compared.
    let scale = covariance.diagonal().map(f64::sqrt);
    let scaled = DMatrix::from_fn(n, n, |i, j| inner[(i, j)] * scale[j] / scale[i]);
    // Where a model tells nothing there is no uncertainty to scale by, and the iteration does not take what is no number.
    if scaled.iter().any(|v| !v.is_finite()) {
        return None;
    }
    let least = scaled.try_svd(false, false, f64::EPSILON, ROUNDS).map(|svd| svd.singular_values.min());
    if least.is_none_or(|least| least < UNTOLD) {
        return None;
    }
    let right = covariance * (jacobian.transpose() * &own);
    inner.lu().solve(&right).map(|v| own + jacobian * v)
}
