//! Other ways of interpolating the same profile: ends on it or shifted, and slides along x and y.

use rayon::prelude::*;

use super::super::cartesian::{self, Block};
use super::super::division::{By, Division, Ends};
use super::super::fewest::{MOST_BLOCKS, error};
use super::super::guide::Guide;
use super::super::program::points;
use super::super::setup::Setup;
use crate::process::{Datum, Figure};
use crate::units::MICRO;

/// Errors below this are none, m.
const NONE: f64 = 1e-10;

/// Figures of the gain by shifted ends, and of the blocks that each interpolation needs; none where there are too many
/// blocks to look at.
pub fn figures(setup: &Setup) -> Vec<Figure> {
    if setup.program.blocks() > MOST_BLOCKS {
        return Vec::new();
    }
    let guide = Guide::new(&setup.profile, setup.wheel_radius);
    let error = largest(setup, &guide, |i| setup.program.shifts[i]);
    let shifted = (setup.division.ends == Ends::HalfError).then(|| shifted(setup, &guide, error));
    shifted.into_iter().chain(coordinates(setup, &guide, error)).collect()
}

/// The largest error of the blocks by their geometry alone, their ends shifted so, m.
fn largest(setup: &Setup, guide: &Guide, shift: impl Fn(usize) -> f64 + Sync) -> f64 {
    let program = &setup.program;
    let end = |i: usize| (program.places[i], shift(i));
    let of = |block: usize| error(&setup.profile, guide, end(block), end(block + 1));
    let errors: Vec<f64> = (0..program.blocks()).into_par_iter().map(of).collect();
    errors.into_iter().fold(0.0, f64::max)
}

fn shifted(setup: &Setup, guide: &Guide, error: f64) -> Figure {
    let unshifted = largest(setup, guide, |_| 0.0);
    let by = setup.program.shifts.iter().map(|shift| shift.abs()).fold(0.0, f64::max);
    let [most, left, without] = [by, error, unshifted].map(|v| MICRO.shown(v));
    let figure = Figure::new("shifted_ends", "shifted ends")
        .line(format!("up to {most:.3}: blocks err by {left:.3} at most, with ends on the profile by {without:.3}"))
        .quantity("largest_shift", MICRO, by)
        .quantity("largest_error", MICRO, error)
        .quantity("largest_error_on_profile", MICRO, unshifted);
    if setup.division.by != By::Tolerance {
        return figure;
    }
    let own: Vec<Option<usize>> = setup.segments.iter().map(|s| s.blocks).collect();
    let division = Division { ends: Ends::OnProfile, ..setup.division };
    let (count, on_profile) = (setup.program.blocks(), points(guide, &setup.profile, &division, &own).len() - 1);
    figure
        .line(format!("with ends on the profile {on_profile} blocks keep the tolerance, so shifted {count}"))
        .entry("blocks", count)
        .entry("blocks_on_profile", on_profile)
}

/// Blocks that keep the tolerance of the programme, or what its blocks err by, for each way of
/// interpolating, segment by segment; their ends on the profile and at its joints.
fn coordinates(setup: &Setup, guide: &Guide, error: f64) -> Option<Figure> {
    let division = &setup.division;
    let tolerance = if division.by == By::Tolerance { division.size } else { error };
    if tolerance < NONE {
        return None;
    }
    let profile = &setup.profile;
    let joints = profile.joints();
    let polar = Division { by: By::Tolerance, size: tolerance, at_joints: true, ends: Ends::OnProfile };
    let ends: Vec<f64> = points(guide, profile, &polar, &[]).into_iter().map(|p| p.0).collect();
    let of = |i: usize| {
        let range = (joints[i], joints[i + 1]);
        let polar = ends.iter().filter(|s| **s > range.0 && **s <= range.1).count();
        let [straight, circular] =
            [Block::Straight, Block::Circular].map(|block| cartesian::fewest(profile, guide, block, range, tolerance));
        [polar, straight, circular]
    };
    let counts: Vec<[usize; 3]> = (0..setup.segments.len()).into_par_iter().map(of).collect();
    let [polar, straight, circular] = [0, 1, 2].map(|i| counts.iter().map(|c| c[i]).sum::<usize>());
    let mut figure = Figure::new("interpolation", "blocks needed")
        .line(format!(
            "to keep {:.3}: {polar} of cam and slide, {straight} straight or {circular} circular of slides along x and y",
            MICRO.shown(tolerance)
        ))
        .quantity("tolerance", MICRO, tolerance)
        .entry("polar", polar)
        .entry("straight", straight)
        .entry("circular", circular);
    let mut list = Vec::new();
    for (i, (segment, [polar, straight, circular])) in setup.segments.iter().zip(counts).enumerate() {
        let name = &segment.name;
        figure = figure.line(format!("{:>2} {name:<26} {polar:>5}, {straight:>5} or {circular:>5}", i + 1));
        list.push(Datum::record([
            ("segment", (i + 1).into()),
            ("polar", polar.into()),
            ("straight", straight.into()),
            ("circular", circular.into()),
        ]));
    }
    Some(figure.entry("segments", Datum::List(list)))
}
