//! The metal that each block removes, and when the wheel touches the cam at all.
//!
//! The turn before has left the same shape, the thickness of the layer farther out, or what its own
//! programme left. A position of the wheel removes what no earlier position of this turn has reached.
//! Where a block cuts too deep, its neighbours have taken its share, and the wheel is lifted off for part
//! of the block; where a block leaves material, the wheel takes much at once as it comes to stand at the
//! end.

use rayon::prelude::*;

use super::super::forward;
use super::super::machine::{Machine, Run};
use super::super::motion::Ray;

/// Parts into which the time of a block is divided.
pub const PARTS: usize = 10;
/// Blocks of a programme that is looked at by tenths: those of short blocks tell nothing, for the contact is
/// longer than they are.
pub const MOST_BLOCKS: usize = 720;
/// A tenth that removes less than this part of what its block removes has lifted off. Less cannot be told in
/// the source's pictures either.
const LIFTED: f64 = 5e-3;

/// The metal that a block removes, per unit width of the cam.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Removal {
    /// Areas in each tenth of the block's time, m²; empty where there are too many blocks to look at tenths.
    pub tenths: Vec<f64>,
    /// Area, m².
    pub area: f64,
}

impl Removal {
    /// The tenths, from 1, in which the wheel cuts.
    pub fn cutting(&self) -> Vec<usize> {
        (1..=self.tenths.len()).filter(|k| self.tenths[k - 1] > LIFTED * self.area).collect()
    }
}

/// A share of a removal: block, tenth, area.
type Share = (usize, usize, f64);

/// The removal of every block from a layer of thickness `stock` (m).
pub fn removals(machine: &Machine, run: &Run, stock: f64) -> Vec<Removal> {
    let program = &machine.setup.program;
    let blocks = program.blocks();
    let parts = if blocks <= MOST_BLOCKS { PARTS } else { 1 };
    let of_block = |block: usize| {
        let count = program.samples(block);
        let width = program.length(block) / count as f64;
        program.middles(block, count).flat_map(|s| shares(machine, run, s, stock, parts, width)).collect()
    };
    let shares: Vec<Vec<Share>> = (0..blocks).into_par_iter().map(of_block).collect();
    let mut removals = vec![Removal { tenths: vec![0.0; parts], area: 0.0 }; blocks];
    for (block, tenth, area) in shares.into_iter().flatten() {
        removals[block].tenths[tenth] += area;
        removals[block].area += area;
    }
    if parts == 1 {
        removals.iter_mut().for_each(|r| r.tenths.clear());
    }
    removals
}

/// Who removes the layer at a place s, over a width of profile.
fn shares(machine: &Machine, run: &Run, s: f64, stock: f64, parts: usize, width: f64) -> Vec<Share> {
    let (setup, motion) = (&machine.setup, &run.motion);
    let ray = Ray::from(setup.profile.at(s));
    let Some(last) = motion.left_along(&ray, motion.first_leg(setup.program.block_at(s))) else { return Vec::new() };
    let count = motion.legs().len();
    // The turn begins where the cam is farthest from the wheel.
    let order = |leg: &usize| (leg + count + count / 2 - last.leg) % count;
    let mut surface = forward::surface(machine, run, s).unwrap_or(last.left + stock);
    let mut near = motion.legs_within(&ray, surface);
    near.sort_unstable_by_key(order);
    let mut shares = Vec::new();
    for number in near {
        let leg = &motion.legs()[number];
        let (from, to) = leg.part;
        let course = setup.program.courses[leg.block];
        let first = ((course.time(from) * parts as f64 + 1e-9) as usize).min(parts - 1);
        let end = ((course.time(to) * parts as f64 - 1e-9).ceil() as usize).clamp(first + 1, parts);
        for part in first..end {
            let time = |k: usize| ((course.way(k as f64 / parts as f64) - from) / (to - from)).clamp(0.0, 1.0);
            let Some(reach) = motion.left_between(&ray, number, (time(part), time(part + 1)), surface) else {
                continue;
            };
            shares.push((leg.block, part, (surface - reach.left) * width));
            surface = reach.left;
        }
    }
    shares
}
