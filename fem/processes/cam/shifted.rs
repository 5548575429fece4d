//! Ends of blocks shifted by half of the error that is to come.
//!
//! Between ends on the profile a block errs to one side, by 4e·t(1 − t) over its part t: e = x''·Δφ²/8 along
//! the slide. With its ends e/2 to the other side it errs by e/2 either way. The error grows with the square
//! of the length, and within the same tolerance blocks are √2 as long [by hand; seed 003 3 asks for a
//! compensation of the error and gives none].
//!
//! With ends at u and v the peak of 4e·t(1 − t) + (1 − t)u + tv stays below a tolerance T where √(T − u) +
//! √(T − v) ≥ 2√e: for u = v = 0 that is e ≤ T, for u = v = −T it is e ≤ 2T. Joints of the profile's
//! segments stay on it, so that a segment without error keeps none and each segment can change the sign of
//! its error; the block beside one is (1 + √2)/2 as long as without shifts, and its error falls by less
//! than half.

use super::fewest::{PRECISION, error, errors, longest, shortest};
use super::guide::Guide;
use super::profile::Profile;

/// Errors below this are round-off, m.
const ROUND_OFF: f64 = 1e-12;

/// Shifts along the normal at places where blocks begin, the first and the last of which stay: half of the
/// larger error beside each, to the other side; nothing where the errors beside it have opposite signs, m.
pub fn shifts(guide: &Guide, profile: &Profile, places: &[f64]) -> Vec<f64> {
    let signed = |w: &[f64]| {
        let (thick, deep) = errors(profile, guide, (w[0], 0.0), (w[1], 0.0));
        if thick > deep { thick } else { -deep }
    };
    let own: Vec<f64> = places.windows(2).map(signed).collect();
    let between = own.windows(2).map(|e| match e[0] * e[1] > ROUND_OFF * ROUND_OFF {
        true if e[0].abs() > e[1].abs() => -0.5 * e[0],
        true => -0.5 * e[1],
        false => 0.0,
    });
    [0.0].into_iter().chain(between).chain([0.0]).take(places.len()).collect()
}

/// Places at which blocks begin between two others, with the shift of each, so that none errs by more than
/// `tolerance` either way, m: the longest block from each place, whichever of the shifts −tolerance, 0 and
/// +tolerance at its end makes it longest. With the last place and without the first.
pub fn fewest(guide: &Guide, profile: &Profile, (from, to): (f64, f64), tolerance: f64) -> Vec<(f64, f64)> {
    let blocks = Blocks { guide, profile, tolerance };
    let mut points = Vec::new();
    let (mut at, mut shift, mut guess) = (from, 0.0, to - from);
    while at < to {
        if blocks.excess((at, shift), (to, 0.0)) <= 1.0 && blocks.keeps((at, shift), (to, 0.0)) {
            points.push((to, 0.0));
            break;
        }
        let mut best = (0.0, 0.0);
        for end in [0.0, tolerance, -tolerance] {
            let excess = |length: f64| blocks.excess((at, shift), (at + length, end));
            // The last block ends on the profile: what would reach the end so shifted ends before it.
            let rest = to - at;
            let length = if excess(rest) <= 1.0 { 0.5 * rest } else { longest(rest, guess, excess) };
            if length > best.0 {
                best = (length, end);
            }
        }
        // The parabola is the first term of the error.
        while best.0 > shortest(profile) && !blocks.keeps((at, shift), (at + best.0, best.1)) {
            best.0 *= 0.998;
        }
        guess = best.0.max(shortest(profile));
        at += guess;
        shift = best.1;
        points.push(if at < to { (at, shift) } else { (to, 0.0) });
    }
    points
}

struct Blocks<'a> {
    guide: &'a Guide<'a>,
    profile: &'a Profile,
    tolerance: f64,
}

impl Blocks<'_> {
    /// The error of a block between two places over what its ends, shifted, allow, by the parabola.
    fn excess(&self, (from, u): (f64, f64), (to, v): (f64, f64)) -> f64 {
        let (thick, deep) = errors(self.profile, self.guide, (from, 0.0), (to, 0.0));
        let allowed = |u: f64, v: f64| {
            let root = |shift: f64| (self.tolerance - shift).max(0.0).sqrt();
            (0.5 * (root(u) + root(v))).powi(2) + PRECISION * self.tolerance
        };
        (thick / allowed(u, v)).max(deep / allowed(-u, -v))
    }

    /// Whether the block with its ends shifted keeps the tolerance.
    fn keeps(&self, from: (f64, f64), to: (f64, f64)) -> bool {
        error(self.profile, self.guide, from, to) <= self.tolerance * (1.0 + 3.0 * PRECISION)
    }
}
