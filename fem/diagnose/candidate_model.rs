//! Candidate model: the model with a set of effects more, fitted.

use crate::fit::{Objective, Solution};
use crate::process::Neutral;

/// Penalty in χ² on an added effect that is larger than is plausible.
const IMPLAUSIBLE: f64 = 6.0;

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

impl CandidateModel<'_> {
    /// Penalised BIC by which candidate models are ranked: χ² with a penalty on every parameter (Schwarz
    /// 1978) and on every effect that is larger than is plausible.
    pub fn penalised_bic(&self) -> f64 {
        let parameters = self.objective.variables.len() - self.objective.priors();
        let penalty = parameters as f64 * (self.objective.data.len() as f64).ln();
        self.solution.chi2 + penalty + IMPLAUSIBLE * self.implausible() as f64
    }

    /// Number of added effects that are larger than is plausible.
    fn implausible(&self) -> usize {
        let too_large = |i: &usize| {
            let Some(entry) = self.objective.catalogue(*i) else { return false };
            let value = entry.kind.from_si(self.objective.variables[*i].value(self.solution.position[*i]));
            match entry.neutral {
                Neutral::Infinity => value < entry.range.0,
                Neutral::Value(_) => value.abs() > entry.range.1,
                Neutral::Shape => false,
            }
        };
        let own = self.objective.data.model.parameters.len();
        (own..self.objective.variables.len()).filter(too_large).count()
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
