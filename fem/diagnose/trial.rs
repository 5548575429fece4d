//! A set of effects on trial.

use crate::fit::{Objective, Solution};
use crate::process::Neutral;

/// An effect that is too large to be plausible is named only where χ² is better by this than with others.
const IMPLAUSIBLE: f64 = 6.0;

/// The model with some effects more, fitted.
#[derive(Clone)]
pub struct Trial<'a> {
    /// Candidates that were added, by number, in the order of adding.
    pub members: Vec<usize>,
    /// What was minimised.
    pub objective: Objective<'a>,
    /// Where the minimum is.
    pub solution: Solution,
}

impl Trial<'_> {
    /// χ² with a price on every parameter (Schwarz 1978) and on every effect that would be larger than is plausible: by it sets are ranked.
    pub fn score(&self) -> f64 {
        let parameters = self.objective.axes.len() - self.objective.priors();
        let price = parameters as f64 * (self.objective.measurements.len() as f64).ln();
        self.solution.chi2 + price + IMPLAUSIBLE * self.implausible() as f64
    }

    /// How many of the added effects would be larger than is plausible.
    fn implausible(&self) -> usize {
        let too_large = |i: &usize| {
            let Some(entry) = self.objective.catalogue(*i) else { return false };
            let value = entry.kind.from_si(self.objective.axes[*i].value(self.solution.position[*i]));
            match entry.neutral {
                Neutral::Infinity => value < entry.range.0,
                Neutral::Value(_) => value.abs() > entry.range.1,
                Neutral::Shape => false,
            }
        };
        let own = self.objective.model.parameters.len();
        (own..self.objective.axes.len()).filter(too_large).count()
    }

    /// Its members in rising order: what makes it the same as another.
    pub fn key(&self) -> Vec<usize> {
        key(&self.members)
    }
}

/// The members in rising order.
pub fn key(members: &[usize]) -> Vec<usize> {
    let mut sorted = members.to_vec();
    sorted.sort_unstable();
    sorted
}
