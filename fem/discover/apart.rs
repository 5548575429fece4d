//! Where two laws that say the same of the rows say most unlike things: the row that would tell them apart.

use nalgebra::DVector;

use super::search::{Bench, Found, amplitudes};
use super::variable::{Variable, product};
use crate::diagnose::Apart;
use crate::units::NUMBER;

/// Values that are tried of each variable, and how far beyond its range, in parts of it.
const VALUES: usize = 9;
const BEYOND: f64 = 0.25;
/// Most variables of which every combination is tried.
const MOST: usize = 4;
/// Part of a column that is left beside what the model's own values imitate, below which they do so.
const IMITATED: f64 = 0.1;

/// The row within a quarter of the range of every variable at which two laws are most apart; `None` where they are made of
/// what cannot be set.
pub fn apart(bench: &Bench, one: &Found, other: &Found) -> Option<Apart> {
    let (first, second) = (one.terms.first()?, other.terms.first()?);
    let is_formula = |law: &Found| {
        let mut factors = law.terms.iter().flat_map(|term| &term.factors);
        factors.any(|own| !bench.variables[own.variable].made_of.is_empty())
    };
    let mut variables = [bench.variables_of(one), bench.variables_of(other)].concat();
    variables.sort_unstable();
    variables.dedup();
    if first.observable != second.observable
        || variables.len() > MOST
        || variables.iter().any(|v| bench.variables[*v].is_prediction)
        || [one, other].into_iter().any(is_formula)
    {
        return None;
    }
    let values: Vec<Vec<f64>> = variables.iter().map(|v| tried(&bench.variables[*v])).collect();
    let count: usize = values.iter().map(Vec::len).product();
    let at = |number: usize| -> Vec<f64> {
        let mut rest = number;
        let one = |own: &Vec<f64>| {
            let value = own[rest % own.len()];
            rest /= own.len();
            value
        };
        values.iter().map(one).collect()
    };
    // The variables at every point that is tried, as if they were rows.
    let points: Vec<Variable> = bench
        .variables
        .iter()
        .enumerate()
        .map(|(v, own)| {
            let place = variables.iter().position(|own| *own == v);
            let value = |number| place.map_or(f64::NAN, |i| at(number)[i]);
            Variable { values: (0..count).map(value).collect(), ..own.clone() }
        })
        .collect();
    let between = |variables: &[Variable], rows: usize| -> Option<Vec<f64>> {
        let (own, rival) = (said(bench, one, variables, rows)?, said(bench, other, variables, rows)?);
        Some(own.iter().zip(rival).map(|(own, rival)| own - rival).collect())
    };
    let at_points = between(&points, count)?;
    let metric = bench.metric(first.observable)?;
    // What the model's own values make of the one and not of the other, such as an offset, is no difference.
    let at_rows = between(bench.variables, bench.rows)?;
    let seen: Vec<usize> = (0..bench.rows).filter(|row| at_rows[*row].is_finite()).collect();
    let of_seen = |column: &[f64]| DVector::from_iterator(seen.len(), seen.iter().map(|row| column[*row]));
    let lines = |variables_at: &[Variable], rows: usize| -> Vec<Vec<f64>> {
        let own = variables.iter().map(|v| variables_at[*v].values.clone());
        std::iter::once(vec![1.0; rows]).chain(own).collect()
    };
    let is_free = |column: &Vec<f64>| {
        let whole = metric.weight() * column.iter().map(|value| value * value).sum::<f64>().sqrt();
        let left = metric.seen(std::slice::from_ref(column)).iter().map(DVector::norm).fold(0.0, f64::max);
        left < IMITATED * whole
    };
    let of_rows = lines(bench.variables, bench.rows);
    let free: Vec<usize> = (0..of_rows.len()).filter(|i| is_free(&of_rows[*i])).collect();
    let columns: Vec<DVector<f64>> = free.iter().map(|i| of_seen(&of_rows[*i])).collect();
    let sizes = if columns.is_empty() { Vec::new() } else { amplitudes(&columns, &of_seen(&at_rows))? };
    let of_points = lines(&points, count);
    let difference = |i: usize| {
        let own: f64 = free.iter().zip(&sizes).map(|(column, size)| size * of_points[*column][i]).sum();
        at_points[i] - own
    };
    let best = (0..count)
        .filter(|i| difference(*i).is_finite())
        .max_by(|a, b| difference(*a).abs().total_cmp(&difference(*b).abs()))?;
    let named = variables.iter().zip(at(best)).map(|(v, value)| {
        let own = &bench.variables[*v];
        (own.name.to_string(), own.kind, value)
    });
    let sigmas = difference(best).abs() * metric.weight();
    Some(Apart { at: named.collect(), difference: difference(best), kind: metric.kind, sigmas })
}

/// What a law says of rows, with the amplitudes that the measured ones give it.
fn said(bench: &Bench, law: &Found, variables: &[Variable], rows: usize) -> Option<Vec<f64>> {
    let sizes = amplitudes(&bench.seen(&law.terms), bench.residual)?;
    let columns = law.terms.iter().flat_map(|term| {
        let factors: Vec<Vec<Vec<f64>>> = term.factors.iter().map(|own| own.columns(variables)).collect();
        product(&factors)
    });
    let mut sum = vec![0.0; rows];
    for (size, column) in sizes.iter().zip(columns) {
        sum.iter_mut().zip(column).for_each(|(sum, value)| *sum += size * value);
    }
    Some(sum)
}

/// Values that are tried of a variable.
fn tried(own: &Variable) -> Vec<f64> {
    let (low, high) = own.ends();
    if own.words > 0 || own.levels.len() < 3 {
        return own.levels.clone();
    }
    let beyond = BEYOND * (high - low);
    let least = if low >= 0.0 { (low - beyond).max(0.0).max(0.5 * low) } else { low - beyond };
    let all = (0..VALUES).map(|k| least + (high + beyond - least) * k as f64 / (VALUES - 1) as f64);
    // Parts and runs are counted.
    let is_counted = own.kind == NUMBER && own.levels.iter().all(|level| level.fract() == 0.0);
    let mut all: Vec<f64> = all.map(|value| if is_counted { value.round().max(1.0) } else { value }).collect();
    all.dedup();
    all
}
