//! One turn of the wheel about the cam, and what it leaves. Between the ends of blocks slide and cam go
//! linearly; what is left along a normal is looked for among many positions of the wheel, and then between
//! them by golden sections.

use std::f64::consts::TAU;

use super::profile::{Place, Profile};

/// Positions of the wheel looked at in a piece of the motion.
const POSITIONS: usize = 8;
/// Pieces that come within this of the least are looked into, mm.
const NEAR: f64 = 0.02;
/// Golden sections, after which a part of 1e-8 of a piece is left: far less than shows where the least is flat.
const SECTIONS: usize = 40;

/// Where cam (rad) and slide (mm) are.
pub type Position = [f64; 2];

/// What the machine makes of a programme.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Machine {
    /// By which the slide is late, s.
    pub lag: f64,
    /// Of the play of the slide, mm.
    pub gap: f64,
    /// Of the wheel's centre above the cam's axis, mm.
    pub height: f64,
    /// That the wheel has lost of its radius, mm.
    pub loss: f64,
}

/// A turn of the cam.
#[derive(Debug, Clone)]
pub struct Motion {
    /// Over each cam and slide go linearly.
    pieces: Vec<[Position; 2]>,
    /// The wheel's centre at evenly spaced times of each piece, ends included, mm.
    centres: Vec<Vec<[f64; 2]>>,
    height: f64,
    radius: f64,
}

/// Angle (rad, rising from that of the start) and slide (mm) at the ends of blocks of equal length, so many on
/// each segment, for a wheel of `radius`.
pub fn programme(profile: &Profile, radius: f64, step: f64) -> Vec<Position> {
    let start = profile.on(0, 0.0).centre(radius);
    let mut ends = vec![[start[1].atan2(start[0]), start[0].hypot(start[1])]];
    for (segment, length) in profile.lengths().into_iter().enumerate() {
        let count = (length / step - 1e-9).ceil().max(1.0);
        for k in 1..=count as usize {
            let [x, y] = profile.on(segment, length * k as f64 / count).centre(radius);
            let last = ends[ends.len() - 1][0];
            let on = (y.atan2(x) - last).rem_euclid(TAU);
            ends.push([last + on, x.hypot(y)]);
        }
    }
    ends
}

impl Motion {
    /// A turn of the cam at `speed` (rad/s), perhaps from the end of the programme to its beginning.
    pub fn new(ends: &[Position], wheel: f64, machine: &Machine, speed: f64, reverse: bool) -> Self {
        let (first, last) = (ends[0][0], ends[ends.len() - 1][0]);
        let from = if reverse { last } else { first };
        let timed = |end: &Position| ((end[0] - from).abs() / speed, end[1]);
        let mut commands: Vec<(f64, f64)> = ends.iter().map(timed).collect();
        if reverse {
            commands.reverse();
        }
        // The slide does late what it does, and the cam has gone on.
        let way = if reverse { -speed } else { speed };
        let reached = |(time, slide): (f64, f64)| [from + way * (time + machine.lag), slide];
        let slides = played(&commands, machine.gap);
        let pieces = slides.windows(2).map(|pair| [reached(pair[0]), reached(pair[1])]).collect();
        let radius = wheel - machine.loss;
        let mut motion = Self { pieces, centres: Vec::new(), height: machine.height, radius };
        let centres = |piece: &[Position; 2]| {
            (0..=POSITIONS).map(|k| motion.centre(piece, k as f64 / POSITIONS as f64)).collect::<Vec<_>>()
        };
        motion.centres = motion.pieces.iter().map(centres).collect();
        motion
    }

    fn centre(&self, [from, to]: &[Position; 2], part: f64) -> [f64; 2] {
        let at = |i: usize| from[i] + part * (to[i] - from[i]);
        let (sine, cosine) = at(0).sin_cos();
        [at(1) * cosine - self.height * sine, at(1) * sine + self.height * cosine]
    }

    /// What is left along the normal of a place, mm, above zero outwards: the least that any position leaves.
    pub fn leaves(&self, place: &Place) -> f64 {
        let (sine, cosine) = place.normal.sin_cos();
        let left = |[x, y]: [f64; 2]| {
            let [dx, dy] = [x - place.point[0], y - place.point[1]];
            let (along, beside) = (dx * cosine + dy * sine, dy * cosine - dx * sine);
            let inside = self.radius * self.radius - beside * beside;
            // A wheel that stands behind the cam grinds another side of it.
            if inside <= 0.0 || along <= 0.0 { f64::INFINITY } else { along - inside.sqrt() }
        };
        let lowest = |centres: &Vec<[f64; 2]>| {
            let seen = centres.iter().map(|c| left(*c)).enumerate();
            seen.fold((0, f64::INFINITY), |least, one| if one.1 < least.1 { one } else { least })
        };
        let seen: Vec<(usize, f64)> = self.centres.iter().map(lowest).collect();
        let mut least = seen.iter().fold(f64::INFINITY, |least, one| least.min(one.1));
        let near = least + NEAR;
        for (piece, &(place, _)) in self.pieces.iter().zip(&seen).filter(|(_, seen)| seen.1 < near) {
            let bound = |k: usize| k as f64 / POSITIONS as f64;
            let (low, high) = (bound(place.saturating_sub(1)), bound((place + 1).min(POSITIONS)));
            least = least.min(golden(low, high, |part| left(self.centre(piece, part))));
        }
        least
    }
}

/// The slide behind its play: a piece of a command is followed half a gap behind, once that has been crossed.
/// Gives the bends of the slide over a turn like all others.
fn played(commands: &[(f64, f64)], gap: f64) -> Vec<(f64, f64)> {
    let half = 0.5 * gap;
    let mut bends = Vec::new();
    let mut stands = commands[0].1;
    for _ in 0..2 {
        bends = vec![(commands[0].0, stands)];
        for pair in commands.windows(2) {
            let ((t0, x0), (t1, x1)) = (pair[0], pair[1]);
            let pushed = x1 - half * (x1 - x0).signum();
            // Nothing moves while the command only crosses the play.
            if (pushed - stands) * (x1 - x0) > 0.0 {
                let part = (stands - (pushed - (x1 - x0))) / (x1 - x0);
                if part > 0.0 {
                    bends.push((t0 + part * (t1 - t0), stands));
                }
                stands = pushed;
            }
            bends.push((t1, stands));
        }
    }
    bends
}

/// The least of a function between two places.
fn golden(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let part = 0.5 * (5_f64.sqrt() - 1.0);
    let (mut a, mut b) = (high - part * (high - low), low + part * (high - low));
    let (mut fa, mut fb) = (f(a), f(b));
    let ends = f(low).min(f(high));
    for _ in 0..SECTIONS {
        if fa < fb {
            (high, b, fb) = (b, a, fa);
            a = high - part * (high - low);
            fa = f(a);
        } else {
            (low, a, fa) = (a, b, fb);
            b = low + part * (high - low);
            fb = f(b);
        }
    }
    fa.min(fb).min(ends)
}
