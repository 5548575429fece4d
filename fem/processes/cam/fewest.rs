//! The fewest blocks that keep a tolerance.
//!
//! The longest block that keeps it is taken from each place. The depth that a block cuts too deep, and the
//! rest it leaves between its ends, do not depend on where other blocks begin, and a part of a block that
//! keeps a tolerance keeps it too; therefore no division into fewer blocks exists.

use super::guide::Guide;
use super::motion::{Leg, Ray, Reach};
use super::profile::Profile;
use super::search::peak;

/// A block is as long as it can be to this part of its length.
pub const PRECISION: f64 = 1e-5;
/// Blocks of a programme that is compared with others: of more the search for the fewest takes longer than
/// the run.
pub const MOST_BLOCKS: usize = 200;
/// Places at which the error of a block is looked at first.
pub const SAMPLES: usize = 9;

/// Places at which blocks begin between two others so that none errs by more than `tolerance` (m), with the
/// last place and without the first. `error` is that of a block between two places, m.
pub fn places(profile: &Profile, (from, to): (f64, f64), tolerance: f64, error: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    let mut places = Vec::new();
    let (mut at, mut guess) = (from, to - from);
    while at < to {
        if error(at, to) <= tolerance {
            places.push(to);
            break;
        }
        guess = longest(to - at, guess, |length| error(at, at + length) / tolerance).max(shortest(profile));
        at += guess;
        places.push(at.min(to));
    }
    places
}

/// Blocks cannot be shorter than what round-off leaves of places, m.
pub fn shortest(profile: &Profile) -> f64 {
    1e-9 * profile.length()
}

/// The longest block up to `rest` whose error is no more than is allowed, m; `excess` is the ratio of the
/// two for a length, and the whole rest exceeds.
pub fn longest(rest: f64, guess: f64, excess: impl Fn(f64) -> f64) -> f64 {
    let (mut good, mut bad) = (0.0, rest);
    let mut length = guess.min(0.5 * rest);
    // The error grows about as the square of the length.
    while bad - good > PRECISION * bad {
        let excess = excess(length);
        *(if excess <= 1.0 { &mut good } else { &mut bad }) = length;
        let aimed = length / excess.max(1e-4).sqrt();
        let aimed = if excess <= 1.0 { aimed * (1.0 + 0.3 * PRECISION) } else { aimed * (1.0 - 0.3 * PRECISION) };
        length = if aimed > good && aimed < bad { aimed } else { 0.5 * (good + bad) };
    }
    good
}

/// The larger of what a single block leaves between its ends, each a place with its shift, and of what it cuts
/// too deep anywhere, m.
pub fn error(profile: &Profile, guide: &Guide, from: (f64, f64), to: (f64, f64)) -> f64 {
    let (thick, deep) = errors(profile, guide, from, to);
    thick.max(deep)
}

/// The most that a single block leaves between its ends, and the depth to which it cuts too deep anywhere,
/// m.
pub fn errors(profile: &Profile, guide: &Guide, from: (f64, f64), to: (f64, f64)) -> (f64, f64) {
    let (leg, radius, range) = (guide.block(from, to), guide.radius(), (from.0, to.0));
    let left = |s: f64| {
        let mut best = Reach::none();
        leg.lower(&Ray::from(profile.at(s)), radius, 0, (0.0, 1.0), &mut best);
        best.left
    };
    (peak(left, range.0, range.1, SAMPLES).1, overcut(profile, &leg, radius, range))
}

/// Depth to which a wheel of `radius` cuts on a leg that is to grind the profile between two places, m: the
/// radius less the distance of the profile from the wheel's centre, where that is shortest. Negative where
/// the wheel stays clear.
pub fn overcut(profile: &Profile, leg: &Leg, radius: f64, (from, to): (f64, f64)) -> f64 {
    let depth = |t: f64| radius - profile.nearest(&leg.centre(t), from + t * (to - from)).1;
    peak(depth, 0.0, 1.0, SAMPLES).1
}
