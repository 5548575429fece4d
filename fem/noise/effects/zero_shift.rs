//! Every part, run or direction was measured from a zero of its own.

use super::super::evidence::Evidence;
use super::super::key::{BY, OBSERVABLE};
use super::super::term::{Acts, Column, MeasurementEffect, Size, Term};
use crate::measure::Measurements;

/// Every level of a grouping coordinate has its own zero.
pub static ZERO_SHIFT: MeasurementEffect = MeasurementEffect {
    name: "zero-shift",
    about: "the instrument or the datum was set to zero anew, or moved, between groups of rows",
    law: "y = prediction + z(level of `by`), z ~ N(0, size^2)",
    source: "Searle, Casella & McCulloch, Variance Components, 1992, ch. 3",
    separates: "measure a master between the groups, or set the zero once for all of them",
    size: Size::OfObservable("size", "standard deviation of the zeros"),
    keys: &[BY, OBSERVABLE],
    example: "0.7 um",
    sets_zero: true,
    acts: Acts::Shared(columns),
    ..MeasurementEffect::USUAL
};

/// One for each observable by everything that groups the rows.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    let grouped = evidence.groupings().into_iter().map(|by| Term { by, ..Term::new(&ZERO_SHIFT) });
    grouped.flat_map(|term| evidence.each_new(term)).collect()
}

/// One column a level: the rows that share its zero.
pub fn columns(term: &Term, measurements: &Measurements) -> Vec<Column> {
    let mut columns: Vec<Column> = Vec::new();
    for (row, level) in measurements.levels(&term.by).into_iter().enumerate() {
        if level >= columns.len() {
            columns.resize(level + 1, Vec::new());
        }
        if term.is_of(measurements, row) {
            columns[level].push((row, 1.0));
        }
    }
    columns.retain(|column| !column.is_empty());
    columns
}

#[cfg(test)]
mod tests {
    use crate::noise::tests::{measured, whitened_square};
    use crate::noise::{Term, effects};

    #[test]
    fn rows_of_a_level_share_a_variance() {
        // Two levels of two rows, sigma 1 and tau 2: V of a level is [[5, 4], [4, 5]].
        let term = Term { by: vec![0], size: 2.0, ..Term::new(&effects::ZERO_SHIFT) };
        let (square, log_determinant) =
            whitened_square(&measured(&[1.0, 1.0, 2.0, 2.0]), &[term], &[1.0, 0.0, 0.0, 2.0]);
        assert!((square - (5.0 / 9.0 + 4.0 * 5.0 / 9.0)).abs() < 1e-12);
        assert!((log_determinant - 2.0 * 9.0f64.ln()).abs() < 1e-12);
    }
}
