//! Common scales of all frames of an animation: size of the bodies, largest displacement, ranges of the fields. Colours
//! and magnification are the same in every frame only if all frames were seen first.

use rayon::prelude::*;

use crate::process::{Animation, Field, Frame, Role, round_below};
use crate::units::{Kind, MICRO};

/// Largest displacement in the picture, as a part of the size of what is made.
const REACH: f64 = 0.1;
/// Displacements below this are none, m.
const NONE: f64 = 1e-12;

/// Common scales of the frames.
#[derive(Clone, Debug)]
pub struct Survey {
    /// How many times displacements are magnified: 1, 2 or 5 times a power of ten.
    pub magnification: f64,
    /// Largest extent of what is made along x, y or z, m.
    pub size: f64,
    /// Largest force, N.
    pub force: f64,
    /// Of every scalar field on what is made, in the order of the fields.
    pub ranges: Vec<Range>,
}

/// Range of a scalar field, SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// Name of the field.
    pub name: String,
    /// Kind of its values.
    pub kind: Kind,
    /// Smallest value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
}

impl Range {
    /// The ends of the colour scale in the kind's own unit: even about zero where the field has both signs, and for
    /// deviations, so that what is as it should be has one colour in all pictures.
    pub fn scale(&self) -> [f64; 2] {
        let [low, high] = [self.low, self.high].map(|si| self.kind.from_si(si));
        let most = low.abs().max(high.abs());
        // What is a hair across zero by round-off has one sign.
        match self.kind == MICRO || low < -1e-6 * most && high > 1e-6 * most {
            true => [-most, most],
            false => [low, high],
        }
    }

    /// The value nearest to zero, which bodies have that the field says nothing of; SI.
    pub fn neutral(&self) -> f64 {
        0.0f64.clamp(self.low, self.high)
    }

    fn extend(&mut self, other: &Self) {
        (self.low, self.high) = (self.low.min(other.low), self.high.max(other.high));
    }
}

/// Extremes of one frame.
struct Seen {
    displacement: f64,
    force: f64,
    bounds: [[f64; 2]; 3],
    ranges: Vec<Range>,
}

impl Survey {
    /// Looks at every frame once.
    pub fn of(animation: &Animation) -> Self {
        let seen = (0..animation.frames).into_par_iter().map(|i| Seen::of(&(animation.frame)(i)));
        let Some(all) = seen.reduce_with(Seen::with) else {
            return Self { magnification: 1.0, size: 1.0, force: 0.0, ranges: Vec::new() };
        };
        let size = all.bounds.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
        let magnification = match all.displacement > NONE && size > 0.0 {
            true => round_below((REACH * size / all.displacement).min(animation.most_magnified)),
            false => 1.0,
        };
        Self { magnification, size: if size > 0.0 { size } else { 1.0 }, force: all.force, ranges: all.ranges }
    }

    /// The range of a field.
    pub fn range(&self, name: &str) -> Option<&Range> {
        self.ranges.iter().find(|range| range.name == name)
    }
}

impl Seen {
    fn of(frame: &Frame) -> Self {
        let grid = &frame.grid;
        let work = || frame.bodies.iter().filter(|b| b.role == Role::Work).flat_map(|b| &b.skin.points);
        let mut nodes: Vec<usize> = work().filter_map(|p| p.node).map(|n| n as usize).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let mut bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for point in work() {
            let origin = point.node.map_or([0.0; 3], |n| grid.points[n as usize]);
            for ((b, o), d) in bounds.iter_mut().zip(origin).zip(point.offset) {
                *b = [b[0].min(o + d), b[1].max(o + d)];
            }
        }
        let length = |v: &[f64]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
        let displacement = grid
            .point_field("displacement")
            .map_or(0.0, |field| nodes.iter().map(|n| length(field.at(*n))).fold(0.0, f64::max));
        let force = grid
            .point_field("force")
            .map_or(0.0, |field| frame.arrows.iter().map(|a| length(field.at(a.node as usize))).fold(0.0, f64::max));
        let range = |field: &Field| Range {
            name: field.name.clone(),
            kind: field.kind,
            low: nodes.iter().map(|n| field.values[*n]).fold(f64::INFINITY, f64::min),
            high: nodes.iter().map(|n| field.values[*n]).fold(f64::NEG_INFINITY, f64::max),
        };
        let ranges = grid.point_fields.iter().filter(|f| f.components == 1 && !nodes.is_empty()).map(range).collect();
        Self { displacement, force, bounds, ranges }
    }

    fn with(self, other: Self) -> Self {
        // Every frame has the same fields; one that shows nothing of the work has no ranges.
        let mut ranges = self.ranges;
        for range in other.ranges {
            match ranges.iter_mut().find(|own| own.name == range.name) {
                Some(own) => own.extend(&range),
                None => ranges.push(range),
            }
        }
        let mut bounds = self.bounds;
        for (own, [low, high]) in bounds.iter_mut().zip(other.bounds) {
            *own = [own[0].min(low), own[1].max(high)];
        }
        Self {
            displacement: self.displacement.max(other.displacement),
            force: self.force.max(other.force),
            bounds,
            ranges,
        }
    }
}
