//! Where the search begins: free parameters that shape an effect are tried over their plausible range, for χ² has many valleys along a time
//! constant or a place.

use nalgebra::DVector;

use super::least_squares::{Patience, minimise};
use super::objective::{Objective, Solution};
use crate::process::Failure;

/// Combinations of starts tried at most.
const MOST: usize = 60;
/// The first, short search from each.
const SHORT: Patience = Patience { steps: 6, fall: 1e-10 };

/// The best minimum over all starts.
pub fn best(objective: &mut Objective) -> Result<Solution, Failure> {
    let mut tried: Vec<Solution> = Vec::new();
    for start in combinations(objective) {
        if let Some(solution) = minimise(objective, &start, &[], SHORT) {
            tried.push(solution);
        }
    }
    tried.sort_by(|a, b| a.chi2.total_cmp(&b.chi2));
    let finals: Vec<Solution> =
        tried.iter().take(3).filter_map(|s| minimise(objective, &s.position, &[], Patience::FULL)).collect();
    finals.into_iter().min_by(|a, b| a.chi2.total_cmp(&b.chi2)).ok_or_else(|| Failure {
        message: "the model cannot be computed anywhere that the fit begins".into(),
        help: "give the parameters values from which `fem run` works".into(),
    })
}

/// Every combination of the parameters' starts, or evenly spread ones of them where there are many.
fn combinations(objective: &Objective) -> Vec<DVector<f64>> {
    let axes = &objective.axes;
    let total = axes.iter().map(|a| a.starts.len()).fold(1usize, usize::saturating_mul);
    let count = total.min(MOST);
    let combination = |k: usize| {
        let mut number = if total == count { k } else { k * (total / count) + k % 5 };
        DVector::from_iterator(
            axes.len(),
            axes.iter().map(|a| {
                let start = a.starts[number % a.starts.len()];
                number /= a.starts.len();
                a.position(start)
            }),
        )
    };
    (0..count).map(combination).collect()
}
