//! The programmed path: a circle, a rectangle or a convex polygon about the origin, once round; a circle from angle 0.

use std::f64::consts::TAU;
use std::sync::Arc;

use crate::process::Spot;
use crate::units::{ANGLE, LENGTH};

/// Components of a velocity below this part of it are round-off: an axis that stands still does not turn
/// round.
const STILL: f64 = 1e-12;

/// The axes, by their position.
pub const AXES: [&str; 2] = ["x", "y"];

/// A closed path.
#[derive(Clone, Debug, PartialEq)]
pub enum Path {
    /// R, m.
    Circle {
        /// m.
        radius: f64,
    },
    /// A rectangle.
    Rectangle {
        /// Along its own first axis, m.
        width: f64,
        /// Across, m.
        height: f64,
        /// Of its first axis from the machine's x, rad.
        angle: f64,
    },
    /// A convex polygon that has the origin inside.
    Polygon {
        /// Counter-clockwise, m.
        corners: Arc<[[f64; 2]]>,
    },
}

/// The way round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// From x to y.
    CounterClockwise,
    /// From y to x.
    Clockwise,
}

/// A point of the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// m.
    pub at: [f64; 2],
    /// Unit vector out of the path.
    pub outward: [f64; 2],
    /// Length of the path up to here, counter-clockwise from where it begins, m.
    pub travelled: f64,
    /// Number of the side, counter-clockwise; a circle has one.
    pub side: usize,
    /// From the ends of the side, counter-clockwise, m; endless for a circle.
    pub from_ends: [f64; 2],
}

/// A straight side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Where it begins, counter-clockwise, m.
    pub from: [f64; 2],
    /// Where it ends, m.
    pub to: [f64; 2],
    /// m.
    pub length: f64,
    /// Along it, counter-clockwise: a unit vector.
    pub along: [f64; 2],
    /// Out of the path: a unit vector.
    pub outward: [f64; 2],
}

impl Side {
    /// The side between two corners of a path that is travelled counter-clockwise (m).
    fn between(from: [f64; 2], to: [f64; 2]) -> Self {
        let way = [to[0] - from[0], to[1] - from[1]];
        let length = way[0].hypot(way[1]);
        let along = way.map(|c| snap(c / length));
        Self { from, to, length, along, outward: [along[1], -along[0]] }
    }

    /// By how much the way turns to the left from this side into the next, rad.
    pub fn turn(&self, next: &Self) -> f64 {
        let ([a, b], [c, d]) = (self.along, next.along);
        (a * d - b * c).atan2(a * c + b * d)
    }
}

/// A component of a unit vector, without what is round-off.
fn snap(component: f64) -> f64 {
    if component.abs() < STILL { 0.0 } else { component }
}

impl Direction {
    /// The words of files, as coordinates keep them by position.
    pub const WORDS: &[(&'static str, Self)] = &[("ccw", Self::CounterClockwise), ("cw", Self::Clockwise)];
    /// The same as a list of words.
    pub const NAMES: &[&'static str] = &["ccw", "cw"];

    /// The word in files.
    pub fn word(self) -> &'static str {
        Self::NAMES[self as usize]
    }

    /// The direction at a position of [`Self::NAMES`].
    pub fn at(position: f64) -> Self {
        if position == Self::Clockwise as usize as f64 { Self::Clockwise } else { Self::CounterClockwise }
    }

    /// +1 counter-clockwise, −1 clockwise.
    pub fn sign(self) -> f64 {
        match self {
            Self::CounterClockwise => 1.0,
            Self::Clockwise => -1.0,
        }
    }
}

impl Path {
    /// Once round, m.
    pub fn length(&self) -> f64 {
        match *self {
            Self::Circle { radius } => TAU * radius,
            Self::Rectangle { width, height, .. } => 2.0 * (width + height),
            Self::Polygon { .. } => self.sides().iter().map(|side| side.length).sum(),
        }
    }

    /// The largest distance of the path from its centre, m.
    pub fn reach(&self) -> f64 {
        match *self {
            Self::Circle { radius } => radius,
            Self::Rectangle { width, height, .. } => 0.5 * width.hypot(height),
            Self::Polygon { ref corners } => corners.iter().map(|[x, y]| x.hypot(*y)).fold(0.0, f64::max),
        }
    }

    /// The sides counter-clockwise, of a rectangle from the one that its first axis points at, of a polygon from its
    /// first corner; none of a circle.
    pub fn sides(&self) -> Vec<Side> {
        let (width, height, angle) = match *self {
            Self::Circle { .. } => return Vec::new(),
            Self::Rectangle { width, height, angle } => (width, height, angle),
            Self::Polygon { ref corners } => {
                let next = corners.iter().cycle().skip(1);
                return corners.iter().zip(next).map(|(from, to)| Side::between(*from, *to)).collect();
            }
        };
        let (sine, cosine) = angle.sin_cos();
        let [u, v] = [[snap(cosine), snap(sine)], [snap(-sine), snap(cosine)]];
        let corner = |a: f64, b: f64| [0, 1].map(|i| 0.5 * (a * width * u[i] + b * height * v[i]));
        let minus = |d: [f64; 2]| d.map(|c| -c);
        let side = |from, to, length, along, outward| Side { from, to, length, along, outward };
        let [se, ne, nw, sw] = [corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0)];
        vec![
            side(se, ne, height, v, u),
            side(ne, nw, width, minus(u), v),
            side(nw, sw, height, minus(v), minus(u)),
            side(sw, se, width, u, minus(v)),
        ]
    }

    /// The point at a polar angle (rad) about the centre.
    pub fn at(&self, angle: f64) -> Point {
        let (sine, cosine) = angle.sin_cos();
        let ray = [cosine, sine];
        match *self {
            Self::Circle { radius } => Point {
                at: ray.map(|c| radius * c),
                outward: ray,
                travelled: radius * angle.rem_euclid(TAU),
                side: 0,
                from_ends: [f64::INFINITY; 2],
            },
            Self::Rectangle { .. } | Self::Polygon { .. } => self.on_side(ray),
        }
    }

    /// Where a ray from the centre meets the straight sides; at a corner, the side that it begins
    /// counter-clockwise.
    fn on_side(&self, ray: [f64; 2]) -> Point {
        let sides = self.sides();
        let reach = |s: &Side| dot(s.from, s.outward) / dot(ray, s.outward);
        let hit = (0..sides.len())
            .filter(|i| dot(ray, sides[*i].outward) > 0.0)
            .min_by(|a, b| reach(&sides[*a]).total_cmp(&reach(&sides[*b])))
            .unwrap_or(0);
        let side = sides[hit];
        let at = ray.map(|c| reach(&side) * c);
        let along = dot([at[0] - side.from[0], at[1] - side.from[1]], side.along);
        // A side whose length is unknown has no end, and nothing lies beyond it.
        let along = if along > side.length { side.length } else { along };
        let along = if along < 0.0 { 0.0 } else { along };
        let before: f64 = sides[..hit].iter().map(|s| s.length).sum();
        Point {
            at,
            outward: side.outward,
            travelled: before + along,
            side: hit,
            from_ends: [along, side.length - along],
        }
    }

    /// The path as it is drawn, closed.
    pub fn drawn(&self) -> Vec<Vec<Spot>> {
        match *self {
            Self::Circle { radius } => vec![Spot::circle(radius)],
            Self::Rectangle { .. } | Self::Polygon { .. } => {
                let sides = self.sides();
                let count = sides.len();
                let corner = |i: usize| {
                    let (behind, ahead) = (sides[(i + count - 1) % count], sides[i % count]);
                    let outward = [0, 1].map(|c| behind.outward[c] + ahead.outward[c]);
                    Spot { at: ahead.from, outward, deviation: 0.0 }
                };
                vec![(0..=count).map(corner).collect()]
            }
        }
    }

    /// In a few words.
    pub fn words(&self) -> String {
        match *self {
            Self::Circle { radius } => format!("circle of radius {}", LENGTH.format(radius)),
            Self::Rectangle { width, height, angle } => {
                format!("rectangle of {} by {} at {}", LENGTH.format(width), LENGTH.format(height), ANGLE.format(angle))
            }
            Self::Polygon { ref corners } => format!("polygon of {} corners", corners.len()),
        }
    }
}

/// The scalar product.
pub fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ray_meets_the_side_that_it_points_at() {
        let angle = 30f64.to_radians();
        let path = Path::Rectangle { width: 0.2, height: 0.1, angle };
        // Along its own axes the ray meets the middles of the sides.
        for (side, turn, distance) in [(0, 0.0, 0.1), (1, 90.0, 0.05), (2, 180.0, 0.1), (3, 270.0, 0.05)] {
            let point = path.at(angle + f64::to_radians(turn));
            assert_eq!(point.side, side);
            assert!((point.at[0].hypot(point.at[1]) - distance).abs() < 1e-15);
            assert!((point.from_ends[0] - point.from_ends[1]).abs() < 1e-15);
        }
        assert!((path.at(angle).travelled - 0.05).abs() < 1e-15);
        assert!((path.at(angle - 1e-9).travelled - 0.05).abs() < 1e-9);
    }

    /// Legs of 60 and 80 mm, the right corner first.
    fn triangle() -> Path {
        Path::Polygon { corners: [[-0.02, -0.02], [0.06, -0.02], [-0.02, 0.04]].into() }
    }

    #[test]
    fn a_triangle_has_the_corners_of_its_legs() {
        let (path, sides) = (triangle(), triangle().sides());
        let lengths: Vec<f64> = sides.iter().map(|side| side.length).collect();
        assert!(lengths.iter().zip([0.08, 0.1, 0.06]).all(|(a, b)| (a - b).abs() < 1e-15), "{lengths:?}");
        assert!((path.length() - 0.24).abs() < 1e-15);
        // At the corners 180 deg less atan 3/4, atan 4/3 and 90 deg.
        let turns: Vec<f64> = (0..3).map(|i| 180.0 - sides[i].turn(&sides[(i + 1) % 3]).to_degrees()).collect();
        let expected = [0.75f64.atan(), (4.0 / 3.0f64).atan(), 0.5 * std::f64::consts::PI].map(f64::to_degrees);
        assert!(turns.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{turns:?}");
        // The ray at 45 deg meets 3x + 4y = 100 mm at x = y = 100/7 mm.
        let point = path.at(std::f64::consts::FRAC_PI_4);
        assert!(point.side == 1 && (point.at[0] - 0.1 / 7.0).abs() < 1e-15, "{point:?}");
        assert!((point.from_ends[0] + point.from_ends[1] - 0.1).abs() < 1e-15);
    }

    #[test]
    fn sides_follow_each_other_counter_clockwise() {
        for path in [Path::Rectangle { width: 0.2, height: 0.1, angle: 0.7 }, triangle()] {
            follow_each_other(&path.sides());
        }
    }

    fn follow_each_other(sides: &[Side]) {
        for (i, side) in sides.iter().enumerate() {
            let next = sides[(i + 1) % sides.len()];
            assert!((0..2).all(|c| (side.to[c] - next.from[c]).abs() < 1e-16));
            assert!((0..2).all(|c| (side.from[c] + side.length * side.along[c] - side.to[c]).abs() < 1e-16));
            // Outwards is to the right of the way.
            assert!((side.along[0] * side.outward[1] - side.along[1] * side.outward[0] + 1.0).abs() < 1e-15);
        }
    }
}
