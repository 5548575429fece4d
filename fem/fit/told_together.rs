//! What no amount of such rows can tell: unknowns on which nothing depends, and pairs of which a law holds one combination
//! alone. Curvature shows both as an open interval; the reason, and with it the remedy, only trial values show.

use super::objective::{Objective, Solution};
use crate::units::Knowledge;

/// The one combination of two unknowns on which rows depend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Combination {
    /// a·b
    Product,
    /// a/b
    Quotient,
    /// a + b
    Sum,
    /// a − b
    Difference,
}

impl Combination {
    const ALL: [Self; 4] = [Self::Product, Self::Quotient, Self::Sum, Self::Difference];

    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Product => "product",
            Self::Quotient => "quotient",
            Self::Sum => "sum",
            Self::Difference => "difference",
        }
    }

    /// Other values of the two that leave it as it is.
    fn kept(self, [a, b]: [f64; 2]) -> [f64; 2] {
        let by = 0.25 * a.abs().max(b.abs());
        match self {
            Self::Product => [a * FACTOR, b / FACTOR],
            Self::Quotient => [a * FACTOR, b * FACTOR],
            Self::Sum => [a + by, b - by],
            Self::Difference => [a + by, b + by],
        }
    }
}

/// Factor of a trial, near enough to stay where a model can be computed.
const FACTOR: f64 = 1.25;
/// Part of a standard uncertainty below which a row has not moved: round-off of the prediction.
const STILL: f64 = 1e-6;

/// Whether no row moves, wherever a parameter stands.
pub fn is_idle(objective: &Objective, solution: &Solution, i: usize) -> bool {
    let (variable, s) = (&objective.variables[i], solution.position[i]);
    let starts = variable.starts.iter().map(|start| variable.position(*start));
    let beside = [s + variable.unit, s - variable.unit, s * FACTOR, s / FACTOR];
    let others = beside.map(|s| s.clamp(variable.low, variable.high)).into_iter().chain(starts);
    let mut tried = others.filter(|other| *other != s).peekable();
    tried.peek().is_some() && tried.all(|other| moved(objective, solution, &[(i, other)]) == Some(false))
}

/// The combination of two parameters on which alone all rows depend, if there is one.
pub fn combination(objective: &Objective, solution: &Solution, i: usize, j: usize) -> Option<Combination> {
    let of = |i: usize| objective.variables[i].value(solution.position[i]);
    let to = |i: usize, value: f64| {
        let variable = &objective.variables[i];
        let position = variable.position(value);
        // Beyond a bound there is no trial.
        ((variable.value(position) / value - 1.0).abs() < 1e-9).then_some((i, position))
    };
    if moved(objective, solution, &[to(i, of(i) * FACTOR)?]) != Some(true) {
        return None;
    }
    let dimension = |i: usize| objective.parameters[i].kind.canonical().dimension;
    let alike = dimension(i) == dimension(j);
    let is_kept = |combination: &Combination| {
        let adds = matches!(combination, Combination::Sum | Combination::Difference);
        let [a, b] = combination.kept([of(i), of(j)]);
        let trial = || Some([to(i, a)?, to(j, b)?]);
        (alike || !adds) && trial().is_some_and(|trial| moved(objective, solution, &trial) == Some(false))
    };
    Combination::ALL.into_iter().find(is_kept)
}

/// Pairs of free parameters whose intervals are open for that reason.
pub fn pairs(objective: &Objective, solution: &Solution, is_open: &[bool]) -> Vec<(usize, usize, Combination)> {
    let is_free = |i: &usize| {
        is_open[*i]
            && objective.variables[*i].steps.is_none()
            && objective.parameters[*i].quantity.knowledge == Knowledge::Free
    };
    let free: Vec<usize> = (0..objective.variables.len()).filter(is_free).collect();
    let pairs = free.iter().enumerate().flat_map(|(k, i)| free[k + 1..].iter().map(move |j| (*i, *j)));
    pairs.filter_map(|(i, j)| Some((i, j, combination(objective, solution, i, j)?))).collect()
}

/// Whether some row moves by more than round-off; `None` where the model cannot be computed.
fn moved(objective: &Objective, solution: &Solution, trial: &[(usize, f64)]) -> Option<bool> {
    let mut position = solution.position.clone();
    trial.iter().for_each(|(i, s)| position[*i] = *s);
    let predicted = objective.predict(&position)?;
    let difference = predicted.iter().zip(&solution.predicted).map(|(there, here)| there - here);
    Some(objective.whiten(difference).iter().any(|z| z.abs() > STILL))
}
