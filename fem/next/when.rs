//! Which part to measure next, and when to change the insert.

use super::ahead::{Ahead, Coming};
use super::filter::State;
use super::line::Events;
use super::sizes::{NOISE, Sizes};

/// Half of an interval that holds 95 %, in standard deviations.
pub const HALF: f64 = 1.96;
/// Probability of being in tolerance that is asked for.
const WANTED: f64 = 0.95;
/// How much wider than that of the next part the interval of a later one may be.
const WIDER: f64 = 1.5;

/// What to measure next.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    /// On which part.
    pub part: usize,
    /// Where, m.
    pub place: f64,
    /// Half of the interval of the mean of the part after it: if nothing is measured, if that is, and if it is measured at the
    /// place that tells the least.
    pub halves: [f64; 3],
    /// Why not later: the probability of being in tolerance falls below what is wanted; else the interval has grown too wide.
    pub is_for_tolerance: bool,
}

/// When to change the insert.
#[derive(Clone, Debug, PartialEq)]
pub struct Insert {
    /// After which part, if the model lets expect that parts come out of tolerance later on whatever the offset.
    pub after: Option<usize>,
    /// The last part that was looked at.
    pub looked: usize,
    /// By how much the diameter has grown by then since the insert was new, SI.
    pub growth: f64,
    /// Whether the drawing asks for anything.
    pub is_asked: bool,
}

/// Which part to measure next at the latest, and where.
pub fn measure(ahead: &Ahead, sizes: &Sizes) -> Measure {
    let wide = WIDER * ahead.parts[0].deviation();
    let is_doubtful = |part: &Coming| ahead.probability(part, part, 0.0).is_some_and(|p| p < WANTED);
    let first = ahead.parts.iter().position(|part| part.deviation() > wide || is_doubtful(part));
    let first = first.unwrap_or(ahead.parts.len() - 1);
    let part = &ahead.parts[first.saturating_sub(1)];
    let noise = sizes.of(NOISE).powi(2);
    // The part after it is told by what is known of this one, but for its own scatter.
    let half = |covariance| {
        let mut own = State { mean: part.state.mean.clone(), covariance };
        own.advance(1, Events::default(), sizes);
        HALF * own.variance(&part.of_mean()).sqrt()
    };
    let halves: Vec<f64> =
        (0..ahead.places.len()).map(|place| half(part.state.after(&part.of_place(place), noise))).collect();
    let (mut best, mut worst) = (0, 0);
    for place in 0..halves.len() {
        if halves[place] < halves[best] {
            best = place;
        }
        if halves[place] > halves[worst] {
            worst = place;
        }
    }
    Measure {
        part: part.number,
        place: ahead.places[best],
        halves: [half(part.state.covariance.clone()), halves[best], halves[worst]],
        is_for_tolerance: is_doubtful(&ahead.parts[first]),
    }
}

/// The part after which no offset keeps parts in tolerance any more, if it does so now. Parts to come will be known as well as the
/// next one is, for they are measured too.
pub fn insert(ahead: &Ahead) -> Insert {
    let next = &ahead.parts[0];
    let is_kept = |part: &Coming| {
        let middle = -part.off() / ahead.answer();
        ahead.probability(part, next, middle).is_some_and(|p| p >= WANTED)
    };
    let last = &ahead.parts[ahead.parts.len() - 1];
    let after = match is_kept(next) {
        true => ahead.parts.iter().position(|part| !is_kept(part)).map(|out| &ahead.parts[out - 1]),
        false => None,
    };
    Insert {
        after: after.map(|part| part.number),
        looked: last.number,
        growth: after.unwrap_or(last).mean() - ahead.sharp.mean(),
        is_asked: !ahead.system().requirements().is_empty(),
    }
}
