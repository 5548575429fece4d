//! What a shop does between parts, on a line, with weights that are tuned on that very line in hindsight.

use crate::line::{Line, PARTS};

/// By how much a unit of the offset changes the diameter, as a shop believes.
const GAIN: f64 = 2.0;

/// How a way of correcting begins anew where something changes.
#[derive(Clone, Copy, PartialEq)]
pub enum Anew {
    /// It does not.
    Never,
    /// The part behind a new insert, a new set-up or with another job is believed as the first one was.
    AtJumps,
}

/// What is left of each part, measured, by a double EWMA: level and rate, each with a weight [Butler & Stefani, IEEE Trans.
/// Semicond. Manuf. 7, 1994]; without the second an EWMA.
fn corrected(line: &Line, weights: (f64, f64), anew: Anew) -> Vec<f64> {
    let (mut level, mut rate) = (0.0, 0.0);
    let step = |part: usize| {
        let offset = -(level + rate) / GAIN;
        let (_, left) = line.mean(part, offset);
        let (off, before) = (left - GAIN * offset, level + rate);
        // The first part is believed.
        if part == 0 || anew == Anew::AtJumps && line.is_new(part) {
            level = off - rate;
        } else {
            rate += weights.1 * (off - before);
            level = weights.0 * off + (1.0 - weights.0) * before;
        }
        left
    };
    (0..PARTS).map(step).collect()
}

/// That of the weights which leaves the least.
pub fn tuned(line: &Line, is_double: bool, anew: Anew, cost: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    let weights: Vec<f64> = (1..=20).map(|i| f64::from(i) / 20.0).collect();
    let rates: Vec<f64> =
        if is_double { [0.0, 0.02].into_iter().chain(weights.iter().copied()).collect() } else { vec![0.0] };
    let all = weights.iter().flat_map(|a| rates.iter().map(move |b| corrected(line, (*a, *b), anew)));
    all.min_by(|a, b| cost(a).total_cmp(&cost(b))).unwrap()
}
