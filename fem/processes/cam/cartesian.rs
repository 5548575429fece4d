//! A programme for two slides along x and y instead of a turning cam and one slide.
//!
//! Straight blocks run the chord of the curve of the wheel's centre, which is a line beside lines and an
//! arc of ρ + R beside arcs of ρ: the chord s errs by its sagitta s²/(8(ρ + R)), and nothing on lines.
//! Circular blocks run an arc through the ends and the middle, without error on lines and arcs [geometry;
//! seed 003 3: such grinders suit profiles of lines and arcs].

use std::f64::consts::PI;

use super::fewest::{self, SAMPLES};
use super::guide::Guide;
use super::profile::{Profile, Vector, direction, turn};
use super::search::peak;

/// The way of the wheel's centre within a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Block {
    /// Along the chord.
    Straight,
    /// Along an arc of half a turn at most.
    Circular,
}

impl Block {
    /// Widest angle about the cam's axis that a block may take up, rad.
    fn widest(self) -> f64 {
        match self {
            Self::Straight => 0.9 * PI,
            Self::Circular => 1.5 * PI,
        }
    }
}

/// The fewest blocks that keep a tolerance (m) between two places of a profile, their ends on it.
pub fn fewest(profile: &Profile, guide: &Guide, block: Block, range: (f64, f64), tolerance: f64) -> usize {
    fewest::places(profile, range, tolerance, |from, to| error(profile, guide, block, from, to)).len()
}

/// The largest error of a block between two places on either side, m.
pub fn error(profile: &Profile, guide: &Guide, block: Block, from: f64, to: f64) -> f64 {
    // Ends that come together again make no block.
    if guide.turn(to).1 - guide.turn(from).1 > block.widest() {
        return f64::INFINITY;
    }
    let radius = guide.radius();
    let [a, middle, b] = [from, 0.5 * (from + to), to].map(|s| profile.at(s).outside(radius));
    let arc = match block {
        Block::Straight => None,
        Block::Circular => match Arc::through(a, middle, b) {
            Some(arc) if arc.sweep.abs() > PI * (1.0 + 1e-9) => return f64::INFINITY,
            arc => arc,
        },
    };
    let off = |t: f64| {
        let centre = arc.as_ref().map_or_else(|| a + (b - a) * t, |arc| arc.at(t));
        (profile.nearest(&centre, from + t * (to - from)).1 - radius).abs()
    };
    peak(off, 0.0, 1.0, SAMPLES).1
}

struct Arc {
    centre: Vector,
    radius: f64,
    from: f64,
    sweep: f64,
}

impl Arc {
    /// The arc from `a` through `middle` to `b`; `None` where they lie on a line.
    fn through(a: Vector, middle: Vector, b: Vector) -> Option<Self> {
        let (u, v) = (middle - a, b - a);
        let twice_area = u.perp(&v);
        // The sagitta of what is left out is below round-off of the coordinates.
        if twice_area.abs() <= 1e-14 * v.norm_squared() {
            return None;
        }
        let square = (u.norm_squared(), v.norm_squared());
        let centre =
            a + Vector::new(v.y * square.0 - u.y * square.1, u.x * square.1 - v.x * square.0) / (2.0 * twice_area);
        let [from, through, to] = [a, middle, b].map(|p| p - centre);
        Some(Self {
            centre,
            radius: from.norm(),
            from: from.y.atan2(from.x),
            sweep: turn(&from, &through) + turn(&through, &to),
        })
    }

    fn at(&self, t: f64) -> Vector {
        self.centre + direction(self.from + t * self.sweep) * self.radius
    }
}
