//! A closed profile.

use std::f64::consts::TAU;

use super::super::search::root;
use super::curve::Curve;
use super::plane::{Place, Vector, direction, left, turn};

/// A stretch of the profile on which the direction from the axis turns by less than half a turn.
#[derive(Clone, Debug, PartialEq)]
struct Stretch {
    curve: Curve,
    /// Its segment in the model file.
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
    /// Length around, m.
    length: f64,
    /// 1 where the chain goes counter-clockwise about the axis, −1 where it goes clockwise.
    sense: f64,
    /// Values of s where segments begin, and the whole length, m.
    joints: Vec<f64>,
}

impl Profile {
    /// A profile of curves with the number of the segment each belongs to; they must follow each other, turn
    /// one way about the axis, and close.
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

    /// Number of the segment at s.
    pub fn segment(&self, s: f64) -> usize {
        self.find(s, false).0.segment
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
        let step = |x: f64| {
            let Place { point, normal, .. } = stretch.curve.place(x, self.sense);
            // dθ/ds = (P·n)/|P|².
            self.sense * turn(&point, &target) * point.norm_squared() / point.dot(&normal)
        };
        let length = stretch.curve.length;
        stretch.start + root(step, 0.5 * length, (0.0, length), 1e-16 * self.length)
    }

    /// Polar angle of the point at s, from 0 to 2π, rad.
    pub fn angle(&self, s: f64) -> f64 {
        let point = self.at(s).point;
        let angle = point.y.atan2(point.x).rem_euclid(TAU);
        if TAU - angle < 1e-12 { 0.0 } else { angle }
    }

    /// The point of the curve nearest to `from`, looked for downhill from `guess`: its s and the distance, m.
    pub fn nearest(&self, from: &Vector, guess: f64) -> (f64, f64) {
        let longest = 0.1 * self.length;
        let step = |s: f64| {
            let place = self.at(s);
            let away = from - place.point;
            let along = away.dot(&(left(&place.normal) * self.sense));
            let slope = 1.0 + place.curvature * away.dot(&place.normal);
            let step = if slope > 0.0 { along / slope } else { longest.copysign(along) };
            step.clamp(-longest, longest)
        };
        let s = root(step, guess, (f64::NEG_INFINITY, f64::INFINITY), 1e-15 * self.length);
        (s, (from - self.at(s).point).norm())
    }

    /// The beginning of the stretch at s, of two that meet there the earlier, and the angle by which the
    /// centre of a wheel of `radius` turns about the axis from there to s, rad.
    pub fn wheel_turn(&self, s: f64, radius: f64) -> (f64, f64) {
        let (stretch, x) = self.find(s, true);
        let centre = |x: f64| stretch.curve.place(x, self.sense).outside(radius);
        (stretch.start, turn(&centre(0.0), &centre(x)))
    }

    /// The same over every stretch.
    pub fn wheel_turns(&self, radius: f64) -> impl Iterator<Item = (f64, f64)> {
        self.stretches.iter().map(move |s| self.wheel_turn(s.start + s.curve.length, radius))
    }

    /// Radius of the tightest hollow, m; infinite where the cam is convex.
    pub fn tightest_hollow(&self) -> f64 {
        let most = self.stretches.iter().map(|s| s.curve.most_hollow(self.sense)).fold(0.0, f64::max);
        if most > 0.0 { 1.0 / most } else { f64::INFINITY }
    }
}
