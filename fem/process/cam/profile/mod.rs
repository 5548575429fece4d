//! The profile of a cam: a closed curve about the cam's axis, walked from its start in the order of the model file.
//!
//! A place is told by s, the length of curve from the start (within an interval of a lift table in proportion to the angle). Every polar angle
//! about the axis meets the curve once.

mod chain;
mod curve;
mod lift;

pub use chain::{Drawn, Segment, read_chain};
pub use curve::Curve;
pub use lift::{Lift, read_lift};

use std::f64::consts::{PI, TAU};

use nalgebra::Vector2;

/// A point or a direction in the cam's plane; the origin is the cam's axis.
pub type Vector = Vector2<f64>;

/// The unit vector at an angle.
pub fn direction(angle: f64) -> Vector {
    let (sine, cosine) = angle.sin_cos();
    Vector::new(cosine, sine)
}

/// A vector turned by a quarter, counter-clockwise.
pub fn left(v: &Vector) -> Vector {
    Vector::new(-v.y, v.x)
}

/// The angle from one vector to another, between −π and π.
pub fn turn(from: &Vector, to: &Vector) -> f64 {
    from.perp(to).atan2(from.dot(to))
}

/// A place on the profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Where, m.
    pub point: Vector,
    /// Outwards.
    pub normal: Vector,
    /// Positive where the cam is convex, 1/m.
    pub curvature: f64,
}

/// A stretch of the profile on which the direction from the axis turns by less than half a turn.
#[derive(Clone, Debug, PartialEq)]
struct Stretch {
    curve: Curve,
    /// Of the model file.
    segment: usize,
    /// s at its beginning, m.
    start: f64,
    /// Polar angle at its beginning, counted on from the profile's start, rad.
    angle: f64,
}

/// A closed profile.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    stretches: Vec<Stretch>,
    /// Around, m.
    length: f64,
    /// 1 where the chain goes counter-clockwise about the axis, −1 where it goes clockwise.
    sense: f64,
    /// s where segments begin, and the whole length.
    joints: Vec<f64>,
}

impl Profile {
    /// A profile of curves with the number of the segment each belongs to; they must follow each other, turn one way about the axis, and close.
    pub fn new(curves: Vec<(usize, Curve)>, sense: f64) -> Self {
        let mut stretches: Vec<Stretch> = Vec::with_capacity(curves.len());
        let mut joints = Vec::new();
        let (mut start, mut angle) = (0.0, 0.0);
        for (segment, curve) in curves {
            let ends = [0.0, curve.length].map(|x| curve.point(x));
            if stretches.is_empty() {
                angle = ends[0].y.atan2(ends[0].x);
            }
            if stretches.last().is_none_or(|last| last.segment != segment) {
                joints.push(start);
            }
            let length = curve.length;
            stretches.push(Stretch { curve, segment, start, angle });
            start += length;
            angle += turn(&ends[0], &ends[1]);
        }
        joints.push(start);
        Self { stretches, length: start, sense, joints }
    }

    /// Length of the whole curve, m.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// 1 where it is walked counter-clockwise, −1 clockwise.
    pub fn sense(&self) -> f64 {
        self.sense
    }

    /// s where the segments begin, in their order, and the whole length.
    pub fn joints(&self) -> &[f64] {
        &self.joints
    }

    /// Smallest distance from the axis at the ends of stretches, m: a size to judge others by.
    pub fn size(&self) -> f64 {
        self.stretches.iter().map(|s| s.curve.point(0.0).norm()).fold(f64::INFINITY, f64::min)
    }

    /// The stretch at s, and how far into it. Of two that meet there the earlier, where `ending` is set.
    fn find(&self, s: f64, ending: bool) -> (&Stretch, f64) {
        let whole = s.rem_euclid(self.length);
        // The end of the curve belongs to the last stretch only to one who comes from there.
        let s = if ending && whole == 0.0 && s > 0.0 { self.length } else { whole };
        let before = |stretch: &Stretch| if ending { stretch.start < s } else { stretch.start <= s };
        let i = self.stretches.partition_point(before).max(1) - 1;
        let stretch = &self.stretches[i];
        (stretch, (s - stretch.start).clamp(0.0, stretch.curve.length))
    }

    /// The place at s; beyond the ends the curve goes round again.
    pub fn at(&self, s: f64) -> Place {
        let (stretch, x) = self.find(s, false);
        stretch.curve.place(x, self.sense)
    }

    /// The same, where s ends a stretch: with the curvature before it.
    pub fn before(&self, s: f64) -> Place {
        let (stretch, x) = self.find(s, true);
        stretch.curve.place(x, self.sense)
    }

    /// Number of the segment at s.
    pub fn segment(&self, s: f64) -> usize {
        self.find(s, false).0.segment
    }

    /// s where stretches begin between two places, without the places themselves.
    pub fn breaks(&self, from: f64, to: f64) -> impl Iterator<Item = f64> {
        self.stretches.iter().map(|s| s.start).filter(move |s| *s > from && *s < to)
    }

    /// s of the point at a polar angle about the axis, rad.
    pub fn at_angle(&self, angle: f64) -> f64 {
        let first = self.stretches[0].angle;
        let ahead = (self.sense * (angle - first)).rem_euclid(TAU);
        let i = self.stretches.partition_point(|s| self.sense * (s.angle - first) <= ahead).max(1) - 1;
        let stretch = &self.stretches[i];
        let target = direction(angle);
        if let Some(x) = stretch.curve.towards(&target, self.sense) {
            return stretch.start + x.clamp(0.0, stretch.curve.length);
        }
        // How far ahead of x the angle is, which falls along the stretch.
        let ahead_of = |x: f64| self.sense * turn(&stretch.curve.point(x), &target);
        let (mut low, mut high) = (0.0, stretch.curve.length);
        let mut x = 0.5 * high;
        for _ in 0..60 {
            let place = stretch.curve.place(x, self.sense);
            let off = ahead_of(x);
            *(if off > 0.0 { &mut low } else { &mut high }) = x;
            // dθ/ds = (P·n)/|P|².
            let step = off * place.point.norm_squared() / place.point.dot(&place.normal);
            if step.abs() <= 1e-16 * self.length {
                break;
            }
            x = if x + step > low && x + step < high { x + step } else { 0.5 * (low + high) };
        }
        stretch.start + x
    }

    /// Polar angle of the point at s, from 0 to 2π, rad.
    pub fn angle(&self, s: f64) -> f64 {
        let point = self.at(s).point;
        let angle = point.y.atan2(point.x).rem_euclid(TAU);
        if TAU - angle < 1e-12 { 0.0 } else { angle }
    }

    /// The point of the curve nearest to `from`, looked for downhill from `guess`: its s and the distance, m.
    pub fn nearest(&self, from: &Vector, guess: f64) -> (f64, f64) {
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut s = guess;
        let longest = 0.1 * self.length;
        for _ in 0..80 {
            let place = self.at(s);
            let away = from - place.point;
            let along = away.dot(&(left(&place.normal) * self.sense));
            *(if along > 0.0 { &mut low } else { &mut high }) = s;
            let slope = 1.0 + place.curvature * away.dot(&place.normal);
            let step = if slope > 0.0 { along / slope } else { longest.copysign(along) };
            let step = step.clamp(-longest, longest);
            if step.abs() <= 1e-15 * self.length {
                break;
            }
            s = if s + step > low && s + step < high { s + step } else { 0.5 * (low + high) };
        }
        (s, (from - self.at(s).point).norm())
    }

    /// How far the centre of a wheel of `radius` turns about the axis from one place to another on one stretch, rad.
    fn turn_of_wheel(&self, stretch: &Stretch, [from, to]: [f64; 2], radius: f64) -> f64 {
        let centre = |x: f64| {
            let place = stretch.curve.place(x, self.sense);
            place.point + place.normal * radius
        };
        turn(&centre(from), &centre(to))
    }

    /// Angles by which the centre of a wheel of `radius` turns about the axis over each stretch, with s of the stretch's beginning.
    pub fn wheel_turns(&self, radius: f64) -> Vec<(f64, f64)> {
        let of = |s: &Stretch| (s.start, self.turn_of_wheel(s, [0.0, s.curve.length], radius));
        self.stretches.iter().map(of).collect()
    }

    /// The angle by which the centre of a wheel of `radius` turns about the axis from the beginning of the stretch to s.
    pub fn wheel_turn_in_stretch(&self, s: f64, ending: bool, radius: f64) -> (f64, f64) {
        let (stretch, x) = self.find(s, ending);
        (stretch.start, self.turn_of_wheel(stretch, [0.0, x], radius))
    }

    /// Radius of the tightest hollow, m; infinite where the cam is convex.
    pub fn tightest_hollow(&self) -> f64 {
        let most = self.stretches.iter().map(|s| s.curve.most_hollow(self.sense)).fold(0.0, f64::max);
        if most > 0.0 { 1.0 / most } else { f64::INFINITY }
    }
}

/// Longest arc in one stretch, rad.
pub const LONGEST_ARC: f64 = 0.25 * PI;

#[cfg(test)]
mod tests;
