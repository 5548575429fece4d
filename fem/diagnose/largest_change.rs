//! What an effect does to the part: the largest change that it makes in the rows that were measured.

use super::candidate_model::CandidateModel;
use super::lead;
use super::search::SearchResult;
use crate::model::Data;
use crate::process::Values;

/// Largest change in the rows of the first observable on which an effect acts, all else as it is in the best model.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct LargestChange {
    /// Its absolute value, SI.
    pub value: f64,
    /// Number of the observable among the file's.
    pub observable: usize,
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
        Some(Self { value, observable })
    }

    /// That of a member of the best set, which is taken out.
    pub fn of_member(found: &SearchResult, best: &CandidateModel, member: usize) -> Option<Self> {
        let bare = lead::bare(&found.base, &found.candidates, best, member)?;
        let changes: Vec<f64> = best.change_from(&bare).collect();
        Self::of(&changes, &best.objective.noise.sigma, best.objective.data)
    }
}
