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
const PRECISION: f64 = 1e-5;
/// Places at which the error of a block is looked at first.
const SAMPLES: usize = 9;

/// Places at which blocks begin between two others so that none errs by more than `tolerance` (m), with the
/// last place and without the first.
pub fn places(guide: &Guide, profile: &Profile, from: f64, to: f64, tolerance: f64) -> Vec<f64> {
    let error = |a: f64, b: f64| error(profile, guide, a, b);
    let mut places = Vec::new();
    let (mut at, mut guess) = (from, to - from);
    while at < to {
        let rest = to - at;
        if error(at, to) <= tolerance {
            places.push(to);
            break;
        }
        let (mut good, mut bad) = (0.0, rest);
        let mut length = guess.min(0.5 * rest);
        // The error grows about as the square of the length.
        while bad - good > PRECISION * bad {
            let excess = error(at, at + length) / tolerance;
            *(if excess <= 1.0 { &mut good } else { &mut bad }) = length;
            let aimed = length / excess.max(1e-4).sqrt();
            let aimed = if excess <= 1.0 { aimed * (1.0 + 0.3 * PRECISION) } else { aimed * (1.0 - 0.3 * PRECISION) };
            length = if aimed > good && aimed < bad { aimed } else { 0.5 * (good + bad) };
        }
        // Blocks cannot be shorter than what round-off leaves of places.
        let step = good.max(1e-9 * profile.length());
        guess = step;
        at += step;
        places.push(at.min(to));
    }
    places
}

/// The larger of what a single block leaves between its ends and of what it cuts too deep anywhere, m.
fn error(profile: &Profile, guide: &Guide, from: f64, to: f64) -> f64 {
    let leg = guide.block(from, to);
    let radius = guide.radius();
    let left = |s: f64| {
        let mut best = Reach::none();
        leg.lower(&Ray::from(profile.at(s)), radius, 0, (0.0, 1.0), &mut best);
        best.left
    };
    let thick = peak(left, from, to, SAMPLES).1;
    thick.max(overcut(profile, &leg, radius, (from, to)))
}

/// Depth to which a wheel of `radius` cuts on a leg that is to grind the profile between two places, m: the
/// radius less the distance of the profile from the wheel's centre, where that is shortest. Negative where
/// the wheel stays clear.
pub fn overcut(profile: &Profile, leg: &Leg, radius: f64, (from, to): (f64, f64)) -> f64 {
    let depth = |t: f64| radius - profile.nearest(&leg.centre(t), from + t * (to - from)).1;
    peak(depth, 0.0, 1.0, SAMPLES).1
}
