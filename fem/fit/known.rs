//! What is known of fitted values together, as it is handed on: of what the data leave open no more is known than what is
//! plausible, and all that hangs together with it is known better by that.

use nalgebra::{DMatrix, DVector};

use super::objective::{Objective, Solution};
use super::spreading::{Spreading, correlation, deviations};
use crate::model::{OtherSet, Spread};

/// What of the standard uncertainties of estimates is handed on, and their correlations.
#[derive(Clone, Debug)]
pub struct Known {
    /// Part of the standard uncertainty of each estimate that is left beside what is plausible.
    pub parts: Vec<f64>,
    /// The same part of values that are spread together, no farther than χ² lets them.
    pub jointly: Vec<f64>,
    /// Their correlations.
    pub correlation: DMatrix<f64>,
    /// Part of the standard uncertainty of each that is left where the others are known.
    pub alone: Vec<f64>,
    /// In which terms each is spread.
    pub spreads: Vec<Spread>,
    /// Other sets of effects that explain the data as well, as far as somebody looked for any.
    pub instead: Vec<OtherSet>,
}

impl Known {
    /// That of estimates at a minimum, from the covariance of the search variables: a plausible range of the catalogue counts
    /// as a standard uncertainty to either side of its middle.
    pub fn of(objective: &Objective, solution: &Solution, covariance: &DMatrix<f64>) -> Self {
        let (variables, n) = (&objective.variables, objective.variables.len());
        let rate = |i: usize| variables[i].rate(solution.position[i]);
        let of_values = DMatrix::from_fn(n, n, |i, j| {
            variables[i].sign() * variables[j].sign() * rate(i) * rate(j) * covariance[(i, j)]
        });
        let plausible = |i: usize| {
            let entry = objective.catalogue(i).filter(|_| variables[i].prior.is_none())?;
            Some((i, 0.5 * (entry.kind.to_si(entry.range.1) - entry.kind.to_si(entry.range.0))))
        };
        let limited: Vec<(usize, f64)> =
            (0..n).filter_map(plausible).filter(|(_, width)| width.is_finite() && *width > 0.0).collect();
        let own = within(&of_values, &limited).unwrap_or_else(|| of_values.clone());
        let usual = || objective.parameters.iter().map(Spread::usual).collect();
        let parts = |covariance: &DMatrix<f64>| -> Vec<f64> {
            let part = |(i, own): (usize, f64)| match own / of_values[(i, i)].sqrt() {
                part if part.is_finite() => part.min(1.0),
                _ => 1.0,
            };
            deviations(covariance).into_iter().enumerate().map(part).collect()
        };
        let (spreads, together) = match Spreading::of(objective, solution, &own) {
            Some(spreading) => {
                let spreads = spreading.spreads();
                let together = spreading.limited(&spreads);
                (spreads, together)
            }
            None => (usual(), own.clone()),
        };
        let correlation = correlation(&together, &deviations(&together));
        let alone = alone(&correlation);
        Self { parts: parts(&own), jointly: parts(&together), correlation, alone, spreads, instead: Vec::new() }
    }
}

/// Finest part of a standard uncertainty to which a value is written.
const FINEST: f64 = 1e-4;

/// What of each standard uncertainty is left where the others are known: 1/√(R⁻¹)ᵢᵢ.
fn alone(correlation: &DMatrix<f64>) -> Vec<f64> {
    let inverse = correlation.clone().cholesky().map(|own| own.inverse());
    let part = |i: usize| inverse.as_ref().map_or(FINEST, |own| own[(i, i)].max(1.0).sqrt().recip().max(FINEST));
    (0..correlation.nrows()).map(part).collect()
}

/// A covariance beside independent knowledge of some of its values: (C⁻¹ + W⁻¹)⁻¹ = C − C·(C + W)⁻¹·C.
fn within(covariance: &DMatrix<f64>, limited: &[(usize, f64)]) -> Option<DMatrix<f64>> {
    let places: Vec<usize> = limited.iter().map(|(i, _)| *i).collect();
    let columns = covariance.select_columns(&places);
    let mut both = columns.select_rows(&places);
    both +=
        DMatrix::from_diagonal(&DVector::from_iterator(limited.len(), limited.iter().map(|(_, width)| width * width)));
    let solved = both.cholesky()?.solve(&columns.transpose());
    Some(covariance - columns * solved)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two values of which only the sum is known: what is plausible of one limits the other.
    #[test]
    fn what_is_plausible_of_one_value_is_known_of_the_other() {
        let (sum, wide) = (0.01f64, 1e6);
        // (a + b)/2 and (a - b)/2 are independent.
        let covariance = DMatrix::from_row_slice(2, 2, &[wide + sum, sum - wide, sum - wide, wide + sum]);
        let own = within(&covariance, &[(0, 2.0)]).unwrap();
        let dense = covariance.try_inverse().unwrap() + DMatrix::from_row_slice(2, 2, &[0.25, 0.0, 0.0, 0.0]);
        let dense = dense.try_inverse().unwrap();
        assert!((own[(0, 0)] - 4.0).abs() < 1e-3 && (own[(1, 1)] - dense[(1, 1)]).abs() < 1e-3, "{own} {dense}");
    }
}
