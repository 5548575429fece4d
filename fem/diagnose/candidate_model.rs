//! Candidate model: the model with a set of effects more, fitted.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};

use super::sensitivity::CandidateEffect;
use crate::fit::{Differences, Objective, Solution};

/// Model with some candidate effects more, fitted.
#[derive(Clone)]
pub struct CandidateModel<'a> {
    /// Numbers of the candidate effects that were added, in the order of adding.
    pub members: Vec<usize>,
    /// Objective that was minimised.
    pub objective: Objective<'a>,
    /// Minimum of the objective.
    pub solution: Solution,
}

/// A candidate model with its weight.
#[derive(Clone)]
pub struct Weighed<'a> {
    /// The model.
    pub model: CandidateModel<'a>,
    /// −2 ln of its posterior, up to a constant: marginal likelihood times prior odds.
    pub criterion: f64,
    /// How often it was fitted from other sets.
    pub fits: usize,
}

impl CandidateModel<'_> {
    /// Jacobian of the residuals, by the slopes of its fit where that has left them; `None` where the model cannot be computed
    /// beside its best values.
    pub fn jacobian(&self) -> Option<DMatrix<f64>> {
        match &self.solution.slopes {
            Some(slopes) => Some(self.objective.jacobian_of(slopes, &self.solution.position)),
            None => self.objective.jacobian(&self.solution),
        }
    }

    /// The same with its slopes, for all who ask for them later; `None` as for [`Self::jacobian`].
    pub fn with_slopes(mut self) -> Option<Self> {
        if self.solution.slopes.is_none() {
            let slopes = self.objective.slopes_about(&self.solution, &[], Differences::Central)?.matrix;
            self.solution.slopes = Some(Arc::new(slopes));
        }
        Some(self)
    }

    /// Residuals of the rows, SI.
    pub fn residuals(&self) -> Vec<f64> {
        self.objective.data.residuals(&self.solution.predicted)
    }

    /// χ² with a penalty on every parameter (Schwarz 1978).
    pub fn bic(&self) -> f64 {
        let parameters = self.objective.variables.len() - self.objective.priors();
        self.solution.chi2 + parameters as f64 * (self.objective.data.len() as f64).ln()
    }

    /// By how much its prediction of every row differs from that of another model, SI.
    pub fn change_from(&self, other: &CandidateModel) -> impl Iterator<Item = f64> {
        self.solution.predicted.iter().zip(&other.solution.predicted).map(|(own, other)| own - other)
    }

    /// Whether its prediction differs from that of another model by the same wherever rows are of the same level.
    pub fn goes_by(&self, other: &CandidateModel, levels: &[usize]) -> bool {
        /// Largest share of the difference's variance within levels.
        const WITHIN: f64 = 0.01;
        let change: Vec<f64> = self.change_from(other).collect();
        sum_of_squares(&change, levels) < WITHIN * sum_of_squares(&change, &vec![0; change.len()])
    }

    /// Where the same set stands with its members in another order; χ² is that of its own noise.
    pub fn solution_of(&self, members: &[usize], candidates: &[CandidateEffect]) -> Solution {
        let mut first = self.objective.data.model.parameters.len();
        let mut order: Vec<usize> = (0..first).collect();
        let mut of_member = std::collections::BTreeMap::new();
        for member in &self.members {
            let end = first + candidates[*member].parameters;
            of_member.insert(*member, first..end);
            first = end;
        }
        order.extend(members.iter().filter_map(|m| of_member.get(m).cloned()).flatten());
        let Solution { position, predicted, chi2, slopes, is_at_rest } = &self.solution;
        Solution {
            position: DVector::from_iterator(order.len(), order.iter().map(|i| position[*i])),
            predicted: predicted.clone(),
            chi2: *chi2,
            slopes: slopes.as_ref().map(|slopes| Arc::new(slopes.select_columns(&order))),
            is_at_rest: *is_at_rest,
        }
    }

    /// Members in rising order, by which equal sets are recognised.
    pub fn key(&self) -> Vec<usize> {
        key(&self.members)
    }
}

/// Members in rising order.
pub fn key(members: &[usize]) -> Vec<usize> {
    let mut sorted = members.to_vec();
    sorted.sort_unstable();
    sorted
}

/// Sum of squares of values about the mean of their level.
fn sum_of_squares(values: &[f64], levels: &[usize]) -> f64 {
    let mut sums = vec![(0.0, 0.0, 0.0); values.len()];
    for (value, level) in values.iter().zip(levels) {
        let (n, sum, square) = &mut sums[*level];
        *n += 1.0;
        *sum += value;
        *square += value * value;
    }
    sums.iter().filter(|s| s.0 > 0.0).map(|(n, sum, square)| square - sum * sum / n).sum()
}
