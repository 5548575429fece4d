//! Readings that are wrong: they are left out of means and tables, and told.

use crate::model::Data;
use crate::noise::{Acts, contradictions, effects};
use crate::positioning::Approach;

/// Targets nearer than this (m) are one.
const SAME: f64 = 1e-9;

/// A reading that is left out.
#[derive(Clone, Debug, PartialEq)]
pub struct WrongReading {
    /// Record of the file, counted from 1.
    pub record: usize,
    /// Line of the file.
    pub line: u64,
    /// The approach.
    pub approach: Approach,
    /// Deviation that was read, m.
    pub value: f64,
    /// Mean of the other approaches to the target from this side, m; `None` where there are none.
    pub others: Option<f64>,
    /// Whether the model says that it is wrong; otherwise it contradicts the other approaches.
    pub is_stated: bool,
}

/// The data with the readings that contradict other approaches to their targets weighed down, beside those
/// that the model weighs down.
pub fn weighed<'m>(data: &Data<'m>, approaches: &[Approach]) -> Data<'m> {
    let stated = stated(data);
    let new: Vec<usize> =
        contradictions(&sides(approaches), &data.observed).into_iter().filter(|row| !stated.contains(row)).collect();
    let term = effects::outlying(new);
    if term.rows.is_empty() { data.clone() } else { data.clone().and_term(term) }
}

/// Number of the target and side of every approach.
fn sides(approaches: &[Approach]) -> Vec<usize> {
    let mut known: Vec<Approach> = Vec::new();
    let is_same = |a: &Approach, b: &Approach| a.direction == b.direction && (a.position - b.position).abs() < SAME;
    let mut number = |approach: &Approach| {
        known.iter().position(|other| is_same(other, approach)).unwrap_or_else(|| {
            known.push(*approach);
            known.len() - 1
        })
    };
    approaches.iter().map(&mut number).collect()
}

/// Rows that effects of the measurement weigh down.
pub fn stated(data: &Data) -> Vec<usize> {
    let weighed = data.terms.iter().filter(|t| matches!(t.effect.acts, Acts::Weighs));
    weighed.flat_map(|t| t.rows.iter().copied()).collect()
}

/// The readings that are left out of `weighed` data, in the order of the file.
pub fn readings(data: &Data, weighed: &Data, approaches: &[Approach]) -> Vec<WrongReading> {
    let (own, all, sides) = (stated(data), stated(weighed), sides(approaches));
    let tell = |row: usize| {
        let others: Vec<f64> = (0..data.len())
            .filter(|other| sides[*other] == sides[row] && !all.contains(other))
            .map(|other| data.observed[other])
            .collect();
        WrongReading {
            record: data.record(row),
            line: data.line(row),
            approach: approaches[row],
            value: data.observed[row],
            others: (!others.is_empty()).then(|| others.iter().sum::<f64>() / others.len() as f64),
            is_stated: own.contains(&row),
        }
    };
    (0..data.len()).filter(|row| all.contains(row)).map(tell).collect()
}
