//! What of a program can carry a correction: which blocks finish the part, and where blocks are put between.

use std::collections::BTreeMap;

use super::knots::knots;
use super::steps::{Shape, Step};
use super::surface::{Sample, Surface};
use super::wanted::{SAME, Wanted};
use super::workpiece::Workpiece;

/// A block that makes a part of the surface, and not that of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Foreign {
    /// The step, by its position.
    pub step: usize,
    /// Where it is farthest off: its radius, and that of the part, m.
    pub radii: [f64; 2],
}

/// The finishing pass.
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    /// The samples that each step finishes, by their positions, for those that finish any.
    pub owned: BTreeMap<usize, Vec<usize>>,
    /// Blocks that cut something else.
    pub foreign: Vec<Foreign>,
    /// The finishing step whose own radius lies farthest off that of the part, and how far, m.
    pub off: Option<(usize, f64)>,
}

impl Finish {
    /// Which steps finish the part: those that make its surface with its radius wherever they do.
    pub fn of(samples: &[Sample], surface: &Surface, work: &Workpiece) -> Self {
        let mut made: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (sample, own) in surface.made.iter().enumerate() {
            if let Some((step, _)) = own {
                made.entry(*step).or_default().push(sample);
            }
        }
        // Its own radius, and that which the part has there.
        let radii = |sample: usize, of: &dyn Fn(f64, f64) -> Option<f64>| {
            let is = surface.made[sample].map_or(f64::NAN, |(_, r)| r);
            [is, of(samples[sample].x, is).unwrap_or(f64::NAN)]
        };
        let off = |radii: &[f64; 2]| (radii[0] - radii[1]).abs();
        let mut finish = Self { owned: BTreeMap::new(), foreign: Vec::new(), off: None };
        for (step, mut own) in made {
            let all = own.iter().map(|sample| radii(*sample, &|x, r| work.radius_near(x, r)));
            let Some(farthest) = all.max_by(|a, b| off(a).total_cmp(&off(b))) else { continue };
            if off(&farthest) > work.agreement {
                finish.foreign.push(Foreign { step, radii: farthest });
                continue;
            }
            if finish.off.is_none_or(|(_, other)| off(&farthest) > other.abs()) {
                finish.off = Some((step, farthest[0] - farthest[1]));
            }
            // Beyond a step of the model the change is that of the other side.
            own.retain(|sample| off(&radii(*sample, &|x, _| work.radius(x))) <= work.agreement);
            if !own.is_empty() {
                finish.owned.insert(step, own);
            }
        }
        finish
    }
}

/// Places, in the way of the tool, at which a finishing block needs others before it, so that straight lines carry what is wanted;
/// none where it needs none, or where none can be put: in a round one, one that counts on, or one that orders more than a motion.
pub fn between(step: &Step, work: &Workpiece, wanted: &Wanted) -> Vec<f64> {
    let Some(cut) = step.cut.filter(|cut| step.is_plain && cut.shape == Shape::Line) else { return Vec::new() };
    let (low, high) = (cut.from.x.min(cut.to.x), cut.from.x.max(cut.to.x));
    let nodes = wanted.between(low, high);
    let increment = work.increment(step.unit).size * step.unit;
    let written = |x: f64| work.zero + ((x - work.zero) / increment).round() * increment;
    let kept = knots(&nodes, work.chord_tolerance);
    let mut places: Vec<f64> = kept.iter().map(|at| written(nodes[*at].0)).collect();
    places.dedup();
    places.retain(|x| *x > low + 0.5 * increment && *x < high - 0.5 * increment && (low + SAME..high).contains(x));
    if cut.to.x < cut.from.x {
        places.reverse();
    }
    places
}
