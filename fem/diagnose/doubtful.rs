//! What is not said though the noise explains what a model leaves: that it is complete, and that the instrument is to blame.
//!
//! A cause that does not help to predict what it was not fitted to is none, and zeros that follow a column are no chance.

use std::collections::BTreeSet;

use super::candidate_model::CandidateModel;
use super::cross_validation::Folds;
use super::verdict::GoodnessOfFit;
use crate::compare::{Judges, SIGNIFICANCE};
use crate::input::Name;
use crate::model::Data;
use crate::noise::{Term, beyond_f};

/// Fewest groups whose zeros are seen to follow a column, or that are left out.
const LEAST_GROUPS: usize = 5;

/// Why the causes of a set are doubtful; `None` where nothing is against them.
pub fn doubt(
    best: &CandidateModel,
    folds: Option<&Folds>,
    before: &GoodnessOfFit,
    after: &GoodnessOfFit,
) -> Option<String> {
    let folds = folds?;
    let (was, is) = (before.cross_validation?, after.cross_validation?);
    let is_told = !best.members.is_empty() && folds.can_be_told(best.objective.data) && is >= was;
    is_told.then(|| {
        let by = &folds.coordinate;
        format!(
            "what is left out by `{by}` is predicted no better with these causes: {is:.2} against {was:.2} of the noise"
        )
    })
}

/// Why the rows are too few for the causes of a set, if they are: no more is left than a few laws would leave of anything, or
/// nothing tells the noise by which one cause is told from another.
pub fn too_few(best: &CandidateModel, judges: Judges) -> Option<String> {
    /// Degrees of freedom that rows leave beside the causes, from which they contradict wrong ones.
    const LEAST_FREEDOM: f64 = 3.0;
    let (data, has_causes) = (best.objective.data, !best.members.is_empty());
    let (rows, places) = (data.len(), data.repeats().groups);
    match has_causes {
        true if judges == Judges::Wrong => Some(format!(
            "rows at {places} places and no column u hardly tell the noise by which causes are told apart: something that \
             is in no catalogue is as likely; repeat the rows, or give the column"
        )),
        true if best.objective.freedom() < LEAST_FREEDOM => Some(format!(
            "{rows} rows are hardly more than the values that were found: something that is in no catalogue is as likely; \
             measure at further places"
        )),
        _ => None,
    }
}

/// The terms of a model, by number, that were found and whose zeros follow a column of the file, with that column.
pub fn terms_that_follow<'m>(best: &CandidateModel<'m>) -> Vec<(usize, &'m Name)> {
    let (data, noise) = (best.objective.data, &best.objective.noise);
    let is_found = |term: &Term| term.effect.sets_zero && !term.by.is_empty() && !term.is_among(&data.terms);
    if !noise.terms.iter().any(is_found) {
        return Vec::new();
    }
    let shares = noise.shares(&best.residuals());
    let found = noise.terms.iter().enumerate().filter(|(_, term)| is_found(term));
    let follows = |(number, term): (usize, &Term)| {
        let column = followed(data, term, &shares[number])?;
        Some((number, &data.model.process.coordinates()[column].name))
    };
    found.filter_map(follows).collect()
}

/// The column that the zeros of a term follow, by its position.
fn followed(data: &Data, term: &Term, shares: &[f64]) -> Option<usize> {
    let levels = data.levels(&term.by);
    let count = levels.iter().max()? + 1;
    let of_level = |level: usize| (0..levels.len()).find(|row| levels[*row] == level && term.is_of(data, *row));
    let firsts: Vec<usize> = (0..count).filter_map(of_level).collect();
    let is_constant = |column: usize| {
        let x = &data.rows.columns[column];
        firsts.len() >= LEAST_GROUPS
            && (0..levels.len()).all(|row| {
                let first = firsts.iter().find(|first| levels[**first] == levels[row]);
                first.is_none_or(|first| x[*first].to_bits() == x[row].to_bits())
            })
    };
    let columns: Vec<usize> = data.given.iter().copied().filter(|column| is_constant(*column)).collect();
    let zeros: Vec<f64> = firsts.iter().map(|row| shares[*row]).collect();
    let p_value = |column: &usize| {
        let x: Vec<f64> = firsts.iter().map(|row| data.rows.columns[*column][*row]).collect();
        (1.0f64).min(line(&x, &zeros)).min(steps(&x, &zeros)) * 2.0 * columns.len() as f64
    };
    let (best, p) = columns.iter().map(|column| (*column, p_value(column))).min_by(|a, b| a.1.total_cmp(&b.1))?;
    (p < SIGNIFICANCE).then_some(best)
}

/// p-value of a straight line through the zeros along a column.
fn line(x: &[f64], zeros: &[f64]) -> f64 {
    let n = x.len() as f64;
    let mean = |v: &[f64]| v.iter().sum::<f64>() / n;
    let (mx, my) = (mean(x), mean(zeros));
    let product =
        |a: &[f64], ma: f64, b: &[f64], mb: f64| a.iter().zip(b).map(|(a, b)| (a - ma) * (b - mb)).sum::<f64>();
    let (xx, xy, yy) = (product(x, mx, x, mx), product(x, mx, zeros, my), product(zeros, my, zeros, my));
    f_test(xy * xy / xx, yy, 1.0, n - 2.0)
}

/// p-value of a value of the zeros for each value of a column, which at least two groups have on average.
fn steps(x: &[f64], zeros: &[f64]) -> f64 {
    let distinct: BTreeSet<u64> = x.iter().map(|x| x.to_bits()).collect();
    if 2 * distinct.len() > x.len() {
        return 1.0;
    }
    let n = x.len() as f64;
    let mean = zeros.iter().sum::<f64>() / n;
    let of = |bits: &u64| {
        let own: Vec<f64> = x.iter().zip(zeros).filter(|(x, _)| x.to_bits() == *bits).map(|(_, z)| z - mean).collect();
        own.iter().sum::<f64>().powi(2) / own.len() as f64
    };
    let whole = zeros.iter().map(|z| (z - mean).powi(2)).sum();
    f_test(distinct.iter().map(of).sum(), whole, distinct.len() as f64 - 1.0, n - distinct.len() as f64)
}

/// p-value of a share of a sum of squares.
fn f_test(explained: f64, whole: f64, freedom: f64, rest: f64) -> f64 {
    if !explained.is_finite() || freedom < 1.0 || rest < 1.0 {
        return 1.0;
    }
    beyond_f(freedom, rest, explained / freedom / ((whole - explained).max(f64::MIN_POSITIVE) / rest)).unwrap_or(1.0)
}
