//! Projects what the model's own free parameters can imitate out of residual and sensitivities, before
//! anything is judged.

use nalgebra::{DMatrix, DVector};

use super::gain::{Gain, gain};
use super::sensitivity::Variant;
use crate::fit::{Objective, Solution};

/// Relative length below which a direction depends on earlier ones.
const DEPENDENT: f64 = 1e-7;
/// Relative length below which what is left of a column is round-off: the free parameters imitate all of it.
const IMITATED: f64 = 1e-6;

/// Residual of a fitted model with everything that its free parameters can imitate projected out. Priors are
/// rows like any others.
pub struct ProjectedResidual {
    /// Orthonormal basis of the datum directions and of the tangent space of the free parameters.
    tangent: DMatrix<f64>,
    /// Standardised residual, measured less predicted.
    pub residual: DVector<f64>,
    /// Degrees of freedom: rows and priors less directions of the basis.
    pub freedom: f64,
}

impl ProjectedResidual {
    /// Projects the residual of a solution; `None` where the model cannot be computed beside it.
    pub fn new(objective: &mut Objective, solution: &Solution) -> Option<Self> {
        let jacobian = objective.jacobian(solution)?;
        Some(Self::beside(objective, jacobian, objective.residuals(&solution.position, &solution.predicted)))
    }

    /// Projects a residual beside a Jacobian.
    pub fn beside(objective: &Objective, jacobian: DMatrix<f64>, residual: DVector<f64>) -> Self {
        let tangent = orthonormal(&with_blind(objective, jacobian));
        let fixed = tangent.ncols() + objective.noise.free_directions();
        let freedom = residual.len().saturating_sub(fixed) as f64;
        let residual = project(&tangent, residual);
        Self { tangent, residual, freedom }
    }

    /// Orthonormal basis of what the free parameters can imitate, in standard uncertainties.
    pub fn tangent(&self) -> &DMatrix<f64> {
        &self.tangent
    }

    /// Projects what the free parameters can imitate out of a vector.
    pub fn project(&self, v: DVector<f64>) -> DVector<f64> {
        project(&self.tangent, v)
    }

    /// Projects what the free parameters can imitate out of every column.
    pub fn project_columns(&self, columns: &DMatrix<f64>) -> DMatrix<f64> {
        columns - &self.tangent * (self.tangent.transpose() * columns)
    }

    /// The columns of a variant without what the free parameters can imitate; `None` where that is all of one of them.
    pub fn seen(&self, variant: &Variant) -> Option<DMatrix<f64>> {
        let left = self.project_columns(&variant.columns);
        let is_seen = |i: usize| left.column(i).norm() > IMITATED * variant.columns.column(i).norm();
        (0..left.ncols()).all(is_seen).then_some(left)
    }

    /// Gain, to first order, when an effect is added in this variant.
    pub fn gain(&self, variant: &Variant) -> Gain {
        let Some(columns) = self.seen(variant) else {
            return Gain { delta_chi2: 0.0, amplitudes: vec![0.0; variant.linear.len()] };
        };
        gain(&(columns.transpose() * &columns), &(columns.transpose() * &self.residual), &variant.signed)
    }
}

/// Puts the datum directions, in standard uncertainties, before those of the parameters: there is neither
/// noise nor sensitivity along them.
fn with_blind(objective: &Objective, jacobian: DMatrix<f64>) -> DMatrix<f64> {
    let blind = &objective.data.datum_directions;
    if blind.is_empty() {
        return jacobian;
    }
    let mut all = DMatrix::zeros(jacobian.nrows(), blind.len() + jacobian.ncols());
    for (column, direction) in blind.iter().enumerate() {
        let whole = objective.noise.whiten(direction.whole(objective.data.len()));
        all.column_mut(column).rows_mut(0, whole.len()).copy_from_slice(&whole);
    }
    all.columns_mut(blind.len(), jacobian.ncols()).copy_from(&jacobian);
    all
}

fn project(tangent: &DMatrix<f64>, v: DVector<f64>) -> DVector<f64> {
    let along = tangent.transpose() * &v;
    v - tangent * along
}

/// Length of a vector when the span of `columns` is projected out of it.
pub fn length_outside(columns: &DMatrix<f64>, v: DVector<f64>) -> f64 {
    project(&orthonormal(columns), v).norm()
}

/// Orthonormalises by Gram and Schmidt, twice, and leaves out directions that depend on earlier ones.
fn orthonormal(columns: &DMatrix<f64>) -> DMatrix<f64> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    for column in columns.column_iter() {
        let size = column.norm();
        let mut v = column.into_owned();
        for _ in 0..2 {
            for b in &basis {
                let along = b.dot(&v);
                v.axpy(-along, b, 1.0);
            }
        }
        if v.norm() > DEPENDENT * size {
            basis.push(v.normalize());
        }
    }
    if basis.is_empty() { DMatrix::zeros(columns.nrows(), 0) } else { DMatrix::from_columns(&basis) }
}
