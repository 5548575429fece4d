//! What of a program can carry a correction: which blocks finish the part, and where blocks are put between.

use std::collections::BTreeMap;

use super::knots::knots;
use super::sample::Sample;
use super::steps::{Shape, Step};
use super::surface::Surface;
use super::wanted::{SAME, Wanted};
use super::workpiece::Workpiece;

/// A block that makes a part of the surface, and not that of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Foreign {
    /// The step, by its position.
    pub step: usize,
    /// Where it is farthest off: its level, and that of the part, m.
    pub levels: [f64; 2],
}

/// The finishing pass.
#[derive(Clone, Debug, PartialEq)]
pub struct Finish {
    /// The samples that each step finishes, by their positions, for those that finish any.
    pub owned: BTreeMap<usize, Vec<usize>>,
    /// Blocks that cut something else.
    pub foreign: Vec<Foreign>,
    /// The finishing step whose own level lies farthest off that of the part, and how far, m.
    pub off: Option<(usize, f64)>,
}

impl Finish {
    /// Which steps finish the part: those that make its surface at its level wherever they do.
    pub fn of(samples: &[Sample], surface: &Surface, work: &Workpiece) -> Self {
        let mut made: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (sample, own) in surface.made.iter().enumerate() {
            if let Some(own) = own {
                made.entry(own.step).or_default().push(sample);
            }
        }
        // Its own level, and that which the part has there.
        let levels = |sample: usize, of: &dyn Fn(f64, f64) -> Option<f64>| {
            let is = surface.made[sample].map_or(f64::NAN, |own| own.r);
            [is, of(samples[sample].x, is).unwrap_or(f64::NAN)]
        };
        let off = |levels: &[f64; 2]| (levels[0] - levels[1]).abs();
        let mut finish = Self { owned: BTreeMap::new(), foreign: Vec::new(), off: None };
        for (step, mut own) in made {
            let all = own.iter().map(|sample| levels(*sample, &|x, r| work.level_near(x, r)));
            let Some(farthest) = all.max_by(|a, b| off(a).total_cmp(&off(b))) else { continue };
            if off(&farthest) > work.agreement {
                finish.foreign.push(Foreign { step, levels: farthest });
                continue;
            }
            if finish.off.is_none_or(|(_, other)| off(&farthest) > other.abs()) {
                finish.off = Some((step, farthest[0] - farthest[1]));
            }
            // Beyond a step of the model the change is that of the other side.
            own.retain(|sample| off(&levels(*sample, &|x, _| work.level(x))) <= work.agreement);
            if !own.is_empty() {
                finish.owned.insert(step, own);
            }
        }
        finish
    }
}

/// Shares of its way, rising, at which a finishing block needs others before it, so that straight lines carry what is
/// wanted; none where it needs none, or where none can be put: in a round one, one that counts on, or one that orders
/// more than a motion.
pub fn between(step: &Step, work: &Workpiece, wanted: &Wanted) -> Vec<f64> {
    let Some(cut) = step.cut.filter(|cut| step.is_plain && cut.shape == Shape::Line) else { return Vec::new() };
    let nodes = wanted.along(&cut);
    let kept = knots(&nodes, work.fineness.chord_tolerance);
    let increment = work.increment(step.unit).size * step.unit;
    // Along the axis on which the way is longer, places are those that can be written.
    let is_along = (cut.to.x - cut.from.x).abs() >= (cut.to.y - cut.from.y).abs();
    let [from, to, zero] = [cut.from, cut.to, work.zero].map(|spot| if is_along { spot.x } else { spot.y });
    let place = |distance: f64| match (cut.to.y - cut.from.y).abs() < SAME {
        true => distance,
        false => from + distance / cut.way() * (to - from),
    };
    let (low, high) = (from.min(to), from.max(to));
    let written = |at: f64| zero + ((at - zero) / increment).round() * increment;
    let mut places: Vec<f64> = kept.iter().map(|at| written(place(nodes[*at].0))).collect();
    if let Some((first, last)) = wanted.ends().filter(|_| work.breadth.is_some() && is_along) {
        // Beside the part a cutter keeps the height that it has at the end of it: it is still over it.
        places.extend([first, last].map(written));
        places.sort_unstable_by(f64::total_cmp);
    }
    places.dedup();
    places.retain(|at| *at > low + 0.5 * increment && *at < high - 0.5 * increment && (low + SAME..high).contains(at));
    let mut shares: Vec<f64> = places.iter().map(|at| (at - from) / (to - from)).collect();
    shares.sort_unstable_by(f64::total_cmp);
    shares
}
