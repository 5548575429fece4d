//! Curves that profiles are made of.

use std::f64::consts::PI;
use std::sync::Arc;

use super::lift::Lift;
use super::plane::{Place, Vector, direction, left};

/// Longest arc in one curve, rad.
const LONGEST_ARC: f64 = 0.25 * PI;

/// The kinds of curves.
#[derive(Clone, Debug, PartialEq)]
enum Shape {
    /// Straight.
    Line { from: Vector, along: Vector },
    /// Part of a circle; `way` is 1 counter-clockwise about its centre, −1 clockwise.
    Arc { centre: Vector, radius: f64, from: f64, way: f64 },
    /// One interval of a lift table.
    Lift { lift: Arc<Lift>, interval: usize },
}

/// A curve from x = 0 to its length.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    shape: Shape,
    /// Length, m.
    pub length: f64,
}

impl Curve {
    /// A straight line.
    pub fn line(from: Vector, to: Vector) -> Self {
        let length = (to - from).norm();
        Self { shape: Shape::Line { from, along: (to - from) / length }, length }
    }

    /// An arc about `centre` from the angle `from` by `sweep`, rad, counter-clockwise positive; long ones in
    /// several curves.
    pub fn arcs(centre: Vector, radius: f64, from: f64, sweep: f64) -> Vec<Self> {
        let count = (sweep.abs() / LONGEST_ARC - 1e-9).ceil().max(1.0);
        let part = sweep / count;
        let arc = |k: usize| Self {
            shape: Shape::Arc { centre, radius, from: from + part * k as f64, way: sweep.signum() },
            length: radius * part.abs(),
        };
        (0..count as usize).map(arc).collect()
    }

    /// One interval of a lift table.
    pub fn lift(lift: &Arc<Lift>, interval: usize) -> Self {
        Self { length: lift.length(interval), shape: Shape::Lift { lift: lift.clone(), interval } }
    }

    /// The point at x.
    pub fn point(&self, x: f64) -> Vector {
        match &self.shape {
            Shape::Line { from, along } => from + along * x,
            Shape::Arc { centre, radius, from, way } => centre + direction(from + way * x / radius) * *radius,
            Shape::Lift { lift, interval } => lift.place(*interval, x / self.length).point,
        }
    }

    /// The place at x of a profile that is walked counter-clockwise (`sense` 1) or clockwise (−1).
    pub fn place(&self, x: f64, sense: f64) -> Place {
        match &self.shape {
            Shape::Line { from, along } => {
                Place { point: from + along * x, normal: -left(along) * sense, curvature: 0.0 }
            }
            Shape::Arc { centre, radius, from, way } => {
                let radial = direction(from + way * x / radius);
                let outwards = sense * way;
                Place { point: centre + radial * *radius, normal: radial * outwards, curvature: outwards / radius }
            }
            Shape::Lift { lift, interval } => lift.place(*interval, x / self.length),
        }
    }

    /// x of the point in a direction (a unit vector) from the origin, by a closed form; beyond the ends where
    /// there is none. `None` for a curve that has no closed form.
    pub fn towards(&self, direction: &Vector, sense: f64) -> Option<f64> {
        match &self.shape {
            Shape::Line { from, along } => Some(-direction.perp(from) / direction.perp(along)),
            Shape::Arc { centre, radius, from, way } => {
                // |d·e − c| = r; of the two the one on whose side the curve faces away from the origin.
                let beside = direction.perp(centre);
                let half = (radius * radius - beside * beside).max(0.0).sqrt();
                let point = direction * (direction.dot(centre) + sense * way * half) - centre;
                let ahead = way * (point.y.atan2(point.x) - from);
                // Just before the beginning rather than nearly a turn behind it.
                Some(radius * ((ahead + 0.5 * PI).rem_euclid(2.0 * PI) - 0.5 * PI))
            }
            Shape::Lift { .. } => None,
        }
    }

    /// Largest −curvature, 1/m.
    pub fn most_hollow(&self, sense: f64) -> f64 {
        match &self.shape {
            Shape::Lift { .. } => (0..=4)
                .map(|k| -self.place(0.25 * f64::from(k) * self.length, sense).curvature)
                .fold(f64::NEG_INFINITY, f64::max),
            _ => -self.place(0.0, sense).curvature,
        }
    }

    /// Twice the area between the curve and the origin, counter-clockwise positive, m².
    pub fn swept(&self) -> f64 {
        let [a, b] = [0.0, self.length].map(|x| self.point(x));
        match &self.shape {
            Shape::Arc { centre, radius, way, .. } => way * radius * self.length + centre.perp(&(b - a)),
            _ => a.perp(&b),
        }
    }

    /// Smallest distance from the origin to the tangent (P × t), taken positive where the curve goes round
    /// the way of `sense`, m.
    pub fn least_arm(&self, sense: f64) -> f64 {
        let arm = |x: f64| {
            let place = self.place(x, sense);
            place.point.dot(&place.normal)
        };
        let ends = arm(0.0).min(arm(self.length));
        match &self.shape {
            // P·n = ±(r + c·e) is least where the radius points against the centre.
            Shape::Arc { centre, radius, from, way } => {
                let outwards = sense * way;
                let worst = centre.y.atan2(centre.x) + if outwards > 0.0 { PI } else { 0.0 };
                let ahead = (way * (worst - from)).rem_euclid(2.0 * PI) * radius;
                if ahead < self.length { ends.min(arm(ahead)) } else { ends }
            }
            Shape::Line { .. } => ends,
            Shape::Lift { .. } => (1..4).map(|k| arm(0.25 * f64::from(k) * self.length)).fold(ends, f64::min),
        }
    }
}
