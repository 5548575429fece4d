//! What shops do instead: each applied to the history of the machine, and tuned on it in hindsight.

use nalgebra::{DMatrix, DVector};

use super::line::{Line, Reading, Step};

/// Steps of a weight.
const WEIGHTS: usize = 20;
/// Parts over which a trend is looked for; all that there are beside them.
const WINDOWS: [usize; 3] = [5, 8, 15];

/// A part of the history without the offset: what would have been measured.
#[derive(Clone, Debug)]
struct Uncorrected {
    /// Number of the part.
    number: usize,
    /// Mean error of its readings less its aim with an offset of zero, SI.
    error: f64,
    /// Each of these, with its place.
    readings: Vec<(f64, f64)>,
}

/// What a rival would have left, and what it would do next.
#[derive(Clone, Debug)]
pub struct Rival {
    /// Key for programs.
    pub key: &'static str,
    /// For people, with what it was tuned to.
    pub words: String,
    /// Mean error that it would have left of each part that was measured, SI.
    pub left: Vec<f64>,
    /// The offset that it would set next, m.
    pub next: f64,
}

/// All of them on a line, none where nothing was measured, given what one unit of the offset does as the shop believes and as the
/// machine answers.
pub fn of(line: &Line, (gain, answer): (f64, f64)) -> Vec<Rival> {
    let parts = &uncorrected(line, answer)[..];
    let first = line.steps.first().map_or(0.0, |step| step.part.offset);
    if parts.is_empty() {
        return Vec::new();
    }
    let weights = || (1..=WEIGHTS).map(|i| i as f64 / WEIGHTS as f64);
    let errors: Vec<f64> = parts.iter().map(|part| part.error).collect();
    let of_mean = |weight: f64| {
        let (left, next) = mean(&errors, first, weight, (gain, answer));
        Rival { key: "ewma", words: format!("EWMA, weight {weight:.2}"), left, next }
    };
    let of_trend = |(a, b): (f64, f64)| {
        let (left, next) = trend(&errors, first, (a, b), (gain, answer));
        Rival { key: "double-ewma", words: format!("double EWMA, weights {a:.2} and {b:.2}"), left, next }
    };
    let of_profile = |window: Option<usize>| {
        let (left, next) = profile(parts, first, window, answer);
        let over = window.map_or("all parts".to_string(), |count| format!("{count} parts"));
        Rival { key: "profile-and-trend", words: format!("same-force profile and mean trend over {over}"), left, next }
    };
    let pairs = weights().flat_map(|a| weights().map(move |b| (a, b)));
    let windows = WINDOWS.iter().map(|count| Some(*count)).chain([None]);
    [best(weights().map(of_mean)), best(pairs.map(of_trend)), best(windows.map(of_profile))]
        .into_iter()
        .flatten()
        .collect()
}

/// That which would have left the least.
fn best(all: impl Iterator<Item = Rival>) -> Option<Rival> {
    let cost = |own: &Rival| own.left.iter().skip(1).map(|left| left * left).sum::<f64>();
    all.min_by(|a, b| cost(a).total_cmp(&cost(b)))
}

/// Every error takes a share of itself off the offset.
fn mean(errors: &[f64], first: f64, weight: f64, (gain, answer): (f64, f64)) -> (Vec<f64>, f64) {
    let mut offset = first;
    let step = |error: &f64| {
        let left = error + answer * offset;
        offset -= weight * left / gain;
        left
    };
    (errors.iter().map(step).collect(), offset)
}

/// Level and rate are both followed [Butler & Stefani, IEEE Trans. Semicond. Manuf. 7, 1994].
fn trend(errors: &[f64], first: f64, weights: (f64, f64), (gain, answer): (f64, f64)) -> (Vec<f64>, f64) {
    let (mut offset, mut level, mut rate) = (first, -gain * first, 0.0);
    let step = |error: &f64| {
        let left = error + answer * offset;
        let disturbance = left - gain * offset;
        let before = level + rate;
        level = weights.0 * disturbance + (1.0 - weights.0) * before;
        rate += weights.1 * (disturbance - before);
        offset = -(level + rate) / gain;
        left
    };
    (errors.iter().map(step).collect(), offset)
}

/// Each place stands off by something of its own, and all move together along a straight line.
fn profile(parts: &[Uncorrected], first: f64, window: Option<usize>, answer: f64) -> (Vec<f64>, f64) {
    let offset = |until: usize, number: usize| match until {
        0 => first,
        _ => -straight(&parts[until - window.unwrap_or(until).min(until)..until], number) / answer,
    };
    let left = parts.iter().enumerate().map(|(i, part)| part.error + answer * offset(i, part.number)).collect();
    let next = parts.last().map_or(1, |part| part.number + 1);
    (left, offset(parts.len(), next))
}

/// The mean error of a part to come by the straight line, over the places of the last part.
fn straight(parts: &[Uncorrected], number: usize) -> f64 {
    let mut places: Vec<f64> = parts.iter().flat_map(|part| part.readings.iter().map(|own| own.0)).collect();
    places.sort_unstable_by(f64::total_cmp);
    places.dedup();
    let Some(last) = parts.last() else { return 0.0 };
    let middle = parts.iter().map(|part| part.number as f64).sum::<f64>() / parts.len() as f64;
    let has_trend = parts.iter().any(|part| part.number != last.number);
    let count = places.len() + usize::from(has_trend);
    let (mut normal, mut right) = (DMatrix::zeros(count, count), DVector::zeros(count));
    let column = |place: f64, number: usize| {
        let mut own = DVector::zeros(count);
        own[places.partition_point(|other| *other < place)] = 1.0;
        if has_trend {
            own[count - 1] = number as f64 - middle;
        }
        own
    };
    for part in parts {
        for (place, error) in &part.readings {
            let own = column(*place, part.number);
            normal += &own * own.transpose();
            right += own * *error;
        }
    }
    let Some(found) = normal.cholesky().map(|own| own.solve(&right)) else { return last.error };
    let own = last.readings.iter().map(|(place, _)| column(*place, number).dot(&found));
    own.sum::<f64>() / last.readings.len().max(1) as f64
}

/// The parts of a line without their offsets, given how readings answer to a unit of the offset.
fn uncorrected(line: &Line, answer: f64) -> Vec<Uncorrected> {
    let measured = line.steps.iter().filter(|step| !step.readings.is_empty());
    let of = |step: &Step| {
        let reading = |own: &Reading| (own.place, own.error - own.aim - answer * step.part.offset);
        let readings: Vec<(f64, f64)> = step.readings.iter().map(reading).collect();
        let error = readings.iter().map(|(_, error)| error).sum::<f64>() / readings.len() as f64;
        Uncorrected { number: step.part.number, error, readings }
    };
    measured.map(of).collect()
}
