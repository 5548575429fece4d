//! Errors on rows that were left out, group by group: what a law says of settings that it was not fitted to.

use nalgebra::{DMatrix, DVector};

use super::levels::Settings;
use super::search::{Bench, Found};

/// Most groups that are left out, one after another.
const MOST: usize = 10;
/// Singular values below this part of the largest are none.
const SINGULAR: f64 = 1e-9;

/// Root mean square of what was predicted of rows that were left out, in standard uncertainties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftOut {
    /// By the model alone.
    pub before: f64,
    /// With the law; its constants stand, its amplitudes are fitted to the other rows.
    pub after: f64,
}

/// The errors with a law and without it; `None` where rows cannot be left out.
pub fn left_out(bench: &Bench, law: &Found, settings: &Settings) -> Option<LeftOut> {
    let rows = bench.rows;
    let groups = match settings.count {
        count if count >= 3 => settings.level.clone(),
        _ => (0..rows).map(|row| row * MOST / rows).collect(),
    };
    let tangent: Vec<DVector<f64>> = bench.tangent.column_iter().map(|column| column.into_owned()).collect();
    let with: Vec<DVector<f64>> = tangent.iter().cloned().chain(bench.seen(&law.terms)).collect();
    Some(LeftOut { before: error(bench, &tangent, &groups)?, after: error(bench, &with, &groups)? })
}

fn error(bench: &Bench, columns: &[DVector<f64>], groups: &[usize]) -> Option<f64> {
    let folds = (groups.iter().max()? + 1).min(MOST);
    let mut squares = 0.0;
    for fold in 0..folds {
        let is_out = |row: &usize| groups.get(*row).is_some_and(|group| group % folds == fold);
        let all = bench.residual.len();
        let own: Vec<usize> = (0..all).filter(|row| !is_out(row)).collect();
        let out: Vec<usize> = (0..all).filter(is_out).collect();
        let part = |rows: &[usize]| DMatrix::from_fn(rows.len(), columns.len(), |i, j| columns[j][rows[i]]);
        let values = |rows: &[usize]| DVector::from_iterator(rows.len(), rows.iter().map(|row| bench.residual[*row]));
        let left = match columns.is_empty() {
            true => values(&out),
            false => {
                let svd = part(&own).svd(true, true);
                let amplitudes = svd.solve(&values(&own), SINGULAR * svd.singular_values.max()).ok()?;
                values(&out) - part(&out) * amplitudes
            }
        };
        squares += left.norm_squared();
    }
    Some((squares / bench.rows as f64).sqrt())
}
