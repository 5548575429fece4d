//! What an effect does to the part: the largest change that it makes in the rows that were measured.

use nalgebra::DMatrix;

use super::candidate_model::CandidateModel;
use super::lead;
use super::search::SearchResult;
use crate::input::Name;
use crate::model::Data;
use crate::process::Values;

/// Largest change in the rows of the first observable on which an effect acts, all else as it is in the best model.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct LargestChange {
    /// Its absolute value, SI.
    pub value: f64,
    /// Its standard uncertainty, SI, by all values together: rows may settle what an effect does to them where they do not
    /// settle its values one by one.
    pub uncertainty: Option<f64>,
    /// How it grows from one part or run to the next, where the process counts them.
    pub growth: Option<Growth>,
    /// Number of the observable among the file's.
    pub observable: usize,
}

/// Growth of a change from the first of some parts or runs to the last, for each of them.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Growth {
    /// What is counted.
    pub along: Name,
    /// Growth for each, SI.
    pub value: f64,
    /// Its standard uncertainty, SI.
    pub uncertainty: f64,
}

/// The tangent of a fitted model: slopes of its prediction, and the covariance of what it leaves open.
pub struct Tangent {
    slopes: DMatrix<f64>,
    covariance: DMatrix<f64>,
}

impl Tangent {
    /// `None` where the model cannot be computed close by.
    pub fn of(best: &CandidateModel) -> Option<Self> {
        let slopes = best.objective.sensitivities(&best.solution.position, &best.objective.data.rows)?;
        let covariance = best.objective.covariance(&best.objective.jacobian_of(&slopes, &best.solution.position));
        Some(Self { slopes, covariance })
    }

    /// Standard uncertainty (SI) of what some of the variables make of a weighted sum of rows.
    fn uncertainty(&self, variables: &std::ops::Range<usize>, rows: &[(usize, f64)]) -> f64 {
        let slope = |i: usize| rows.iter().map(|(row, weight)| weight * self.slopes[(*row, i)]).sum::<f64>();
        let own = || variables.clone();
        let variance: f64 =
            own().map(|i| own().map(|j| slope(i) * self.covariance[(i, j)] * slope(j)).sum::<f64>()).sum();
        variance.max(0.0).sqrt()
    }
}

impl LargestChange {
    /// The largest of the changes of all rows (SI); `None` where nothing changes.
    pub fn of(changes: &[f64], sigma: &Values, data: &Data) -> Option<Self> {
        /// Part of the largest change, in standard uncertainties, below which an observable changes by round-off alone.
        const ROUND_OFF: f64 = 1e-6;
        let relative = |row: usize| (changes[row] / sigma[row]).abs();
        let least = ROUND_OFF * (0..changes.len()).map(relative).fold(0.0, f64::max);
        let rows = data.rows_by_observable();
        let observable = rows.iter().position(|own| own.iter().any(|row| relative(*row) > least))?;
        let value = rows[observable].iter().map(|row| changes[*row].abs()).fold(0.0, f64::max);
        Some(Self { value, uncertainty: None, growth: None, observable })
    }

    /// That of a member of the best set, which is taken out.
    pub fn of_member(
        found: &SearchResult,
        best: &CandidateModel,
        member: usize,
        tangent: Option<&Tangent>,
    ) -> Option<Self> {
        let bare = lead::bare(&found.base, &found.candidates, best, member)?;
        let changes: Vec<f64> = best.change_from(&bare).collect();
        let data = best.objective.data;
        let own = Self::of(&changes, &best.objective.noise.sigma, data)?;
        let Some(tangent) = tangent else { return Some(own) };
        let before = best.members.iter().take_while(|m| **m != member).map(|m| found.candidates[*m].parameters);
        let first = found.base.objective.variables.len() + before.sum::<usize>();
        let variables = first..first + found.candidates[member].parameters;
        let rows = &data.rows_by_observable()[own.observable];
        let most = rows.iter().copied().max_by(|a, b| changes[*a].abs().total_cmp(&changes[*b].abs()))?;
        let uncertainty = Some(tangent.uncertainty(&variables, &[(most, 1.0)]));
        let growth = growth(data, rows, &changes, |weights| tangent.uncertainty(&variables, weights));
        Some(Self { uncertainty, growth, ..own })
    }
}

/// How changes grow from the first part or run to the last.
fn growth(
    data: &Data,
    rows: &[usize],
    changes: &[f64],
    uncertainty: impl Fn(&[(usize, f64)]) -> f64,
) -> Option<Growth> {
    let process = &*data.model.process;
    let along = process.in_order()?;
    let column = process.coordinates().iter().position(|coordinate| coordinate.name == *along)?;
    let at = |row: usize| data.rows.columns[column][row];
    let numbers = || rows.iter().map(|row| at(*row)).filter(|number| number.is_finite());
    let [first, last] = [numbers().fold(f64::INFINITY, f64::min), numbers().fold(f64::NEG_INFINITY, f64::max)];
    // Without any number the ends are infinite.
    if !first.is_finite() || last - first < 2.0 {
        return None;
    }
    let ends = |number: f64, sign: f64| {
        let own: Vec<usize> = rows.iter().copied().filter(|row| at(*row) == number).collect();
        let weight = sign / (own.len() as f64 * (last - first));
        own.into_iter().map(move |row| (row, weight)).collect::<Vec<_>>()
    };
    let weights = [ends(last, 1.0), ends(first, -1.0)].concat();
    let value = weights.iter().map(|(row, weight)| weight * changes[*row]).sum();
    Some(Growth { along: along.into(), value, uncertainty: uncertainty(&weights) })
}
