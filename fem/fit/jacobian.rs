//! Derivatives of the prediction and of the residuals by the search variables.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::objective::{Objective, Solution};
use crate::process::Rows;

/// Differences by which a Jacobian is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Differences {
    /// From the point itself, one evaluation a variable.
    Forward,
    /// From either side, two evaluations.
    Central,
}

impl Objective<'_> {
    /// Slopes of the prediction about a point by these differences: SI per unit of the search variables, which no
    /// noise changes; columns of variables that are `held` are zero.
    pub fn slopes_about(&self, here: &Solution, held: &[usize], differences: Differences) -> Option<DMatrix<f64>> {
        let column = |i: usize| -> Option<Vec<f64>> {
            if held.contains(&i) {
                return Some(vec![0.0; here.predicted.len()]);
            }
            let ends: [f64; 2] = self.around(&here.position, i).into();
            let at = |s: f64| {
                let mut moved = here.position.clone();
                moved[i] = s;
                self.predict(&moved)
            };
            let (near, far, step) = match differences {
                Differences::Central => (at(ends[0])?, at(ends[1])?, ends[1] - ends[0]),
                Differences::Forward => {
                    // Inwards at a bound.
                    let far = |s: &f64| (s - here.position[i]).abs();
                    let s = if far(&ends[1]) >= far(&ends[0]) { ends[1] } else { ends[0] };
                    (here.predicted.clone(), at(s)?, s - here.position[i])
                }
            };
            Some(far.iter().zip(&near).map(|(far, near)| (far - near) / step).collect())
        };
        match differences {
            Differences::Central => self.columns(here.predicted.len(), column),
            // The rough searches that take these run side by side, and would only wait for each other.
            Differences::Forward => matrix(here.predicted.len(), (0..self.variables.len()).map(column)),
        }
    }

    /// Jacobian of the residuals, those of the priors included, by the slopes of the prediction at a position.
    pub fn jacobian_of(&self, slopes: &DMatrix<f64>, position: &DVector<f64>) -> DMatrix<f64> {
        let mut jacobian = DMatrix::zeros(slopes.nrows() + self.priors(), slopes.ncols());
        let mut prior = slopes.nrows();
        for (i, variable) in self.variables.iter().enumerate() {
            let column = self.noise.whiten(slopes.column(i).iter().map(|slope| -slope));
            jacobian.column_mut(i).rows_mut(0, column.len()).copy_from_slice(&column);
            if let Some((_, std)) = variable.prior {
                let (low, high) = self.around(position, i);
                jacobian[(prior, i)] = (variable.value(low) - variable.value(high)) / ((high - low) * std);
                prior += 1;
            }
        }
        jacobian
    }

    /// Jacobian of the residuals by central differences, one-sided at a bound.
    pub fn jacobian(&self, here: &Solution) -> Option<DMatrix<f64>> {
        let slopes = self.slopes_about(here, &[], Differences::Central)?;
        Some(self.jacobian_of(&slopes, &here.position))
    }

    /// Sensitivities: derivatives of the prediction of any rows, SI per unit of the search variables.
    pub fn sensitivities(&self, position: &DVector<f64>, rows: &Rows) -> Option<DMatrix<f64>> {
        let column = |i: usize| {
            let (low, high) = self.around(position, i);
            let at = |s: f64| {
                let mut moved = position.clone();
                moved[i] = s;
                self.predict_rows(&moved, rows)
            };
            let (high_end, low_end) = (at(high)?, at(low)?);
            Some(high_end.iter().zip(&low_end).map(|(h, l)| (h - l) / (high - low)).collect())
        };
        self.columns(rows.len(), column)
    }

    /// A matrix with a column for each variable, made on all threads; `None` where one of them cannot be made.
    fn columns(&self, rows: usize, column: impl Fn(usize) -> Option<Vec<f64>> + Send + Sync) -> Option<DMatrix<f64>> {
        // All are made, so that the count of evaluations does not depend on which thread was the first to fail.
        let all: Vec<Option<Vec<f64>>> = (0..self.variables.len()).into_par_iter().map(column).collect();
        matrix(rows, all.into_iter())
    }

    /// Derivatives of the prediction of the measured rows by the free variables, beside the datum directions,
    /// SI.
    pub fn mean(&self, solution: &Solution) -> Option<DMatrix<f64>> {
        let own = self.sensitivities(&solution.position, &self.data.rows)?;
        let blind = &self.data.datum_directions;
        let mut all = DMatrix::zeros(self.data.len(), blind.len() + own.ncols());
        for (column, direction) in blind.iter().enumerate() {
            all.column_mut(column).copy_from_slice(&direction.whole(self.data.len()));
        }
        all.columns_mut(blind.len(), own.ncols()).copy_from(&own);
        Some(all)
    }

    /// Two values of a search variable close by, for a central difference; one-sided at a bound.
    fn around(&self, position: &DVector<f64>, i: usize) -> (f64, f64) {
        let variable = &self.variables[i];
        let step = 1e-4 * variable.unit.max(1e-3 * position[i].abs());
        ((position[i] - step).max(variable.low), (position[i] + step).min(variable.high))
    }
}

/// The matrix of these columns, if all could be made.
fn matrix(rows: usize, columns: impl ExactSizeIterator<Item = Option<Vec<f64>>>) -> Option<DMatrix<f64>> {
    let mut matrix = DMatrix::zeros(rows, columns.len());
    for (mut to, from) in matrix.column_iter_mut().zip(columns) {
        to.copy_from_slice(&from?);
    }
    Some(matrix)
}
