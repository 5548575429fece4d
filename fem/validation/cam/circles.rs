//! Circles about the cam's axis and beside it, and Archimedean spirals.

use std::f64::consts::{PI, TAU};

use super::rig::*;
use crate::processes::cam::motion::{Leg, Motion, Ray};
use crate::processes::cam::report::blocks::{Block, Blocks};
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [concentric(), spiral(), beside(), halving(), anywhere()].concat()
}

fn blocks_of(count: usize) -> String {
    format!("blocks = {count}\ncam_speed = \"20 rpm\"")
}

fn concentric() -> Vec<Case> {
    let case = |count: usize| {
        let computed = usual(&cam(&circle(14.0, 0.0, true), 175.0, &blocks_of(count), ""), 33.3);
        let source = "seed 003, 2.3: concentric arcs are without error";
        micro(format!("concentric circle, {count} block(s)"), (0.0, computed), ROUND_OFF, source)
    };
    [1, 7].map(case).to_vec()
}

/// The cam whose wheel centre is to run a spiral: a block does it without error.
fn spiral() -> Vec<Case> {
    let leg = Leg::new((0.3, 0.6), (0.19, 0.012), 0.0, 0, (0.0, 1.0));
    let motion = Motion::new(vec![leg.clone()], 0.175);
    let case = |t: f64| {
        let normal = leg.outwards(t, 1.0);
        let ray = Ray { point: leg.centre(t) - normal * 0.175, normal };
        let computed = motion.left_along(&ray, 0).map_or(f64::NAN, |reach| 1e6 * reach.left);
        let source = "seed 003, 3: offsets of Archimedean spirals are without error";
        micro(format!("offset of a spiral, {t} of a block"), (0.0, computed), ROUND_OFF, source)
    };
    [0.2, 0.5, 0.93].map(case).to_vec()
}

/// Distance of the centre of a wheel of 175 mm on a circle of 20 mm, 4 mm beside the axis, in mm, at its
/// polar angle.
fn slide(angle: f64) -> f64 {
    4.0 * angle.cos() + (195.0f64.powi(2) - (4.0 * angle.sin()).powi(2)).sqrt()
}

/// A block that lies evenly about the line of centres runs a concentric arc: it errs by the difference of the
/// slide at its ends and in its middle.
fn beside() -> Vec<Case> {
    let case = |(count, at_farthest): (usize, bool)| {
        let middle = if at_farthest { 0.0 } else { PI };
        let expected = 1e3 * (slide(middle + PI / count as f64) - slide(middle));
        let computed = usual(&cam(&circle(20.0, 4.0, !at_farthest), 175.0, &blocks_of(count), ""), middle.to_degrees());
        let name = if at_farthest { "farthest" } else { "nearest" };
        let name = format!("circle 4 mm beside, {name} point, {count} blocks");
        micro(name, (expected, computed), ROUND_OFF, "x(pi/n) - x(0), x the slide")
    };
    [(9, false), (45, false), (361, false), (9, true), (45, true), (361, true)].map(case).to_vec()
}

/// Half as long blocks err by a quarter.
fn halving() -> Vec<Case> {
    let worst = |count: usize, error: fn(&Block) -> f64| {
        let blocks = blocks(&cam(&circle(20.0, 4.0, true), 175.0, &blocks_of(count), ""));
        blocks.map_or(f64::NAN, |b| b.list.iter().map(error).fold(0.0, f64::max))
    };
    type Error = (&'static str, fn(&Block) -> f64);
    let errors: [Error; 2] = [("thickening", |b| b.thickest.0), ("overcut", |b| -b.thinnest.0)];
    // The next term of the error is of the order of the square of a block's angle.
    let tolerance = Tolerance::Relative((TAU / 90.0).powi(2));
    let source = "seed 003, 3; tolerance: square of a block's angle";
    let case = |(what, error)| {
        let values = (4.0, worst(90, error) / worst(180, error), "-");
        row(format!("blocks of 4 deg against 2 deg, {what}"), "error", values, tolerance, source)
    };
    errors.map(case).to_vec()
}

/// The error of a short block is |x''|·Δφ²/8 along the slide, with the cosine of the angle between slide
/// and normal.
fn anywhere() -> Vec<Case> {
    const COUNT: usize = 720;
    let angle = TAU / COUNT as f64;
    let blocks = blocks(&cam(&circle(20.0, 4.0, true), 175.0, &blocks_of(COUNT), ""));
    let case = |number: usize| {
        let middle = (number as f64 + 0.5) * angle;
        let bend = (slide(middle + 1e-4) - 2.0 * slide(middle) + slide(middle - 1e-4)) / 1e-8;
        // The normal goes through the circle's centre: (W − c)·W/(|W − c||W|).
        let cosine = (slide(middle) - 4.0 * middle.cos()) / 195.0;
        let expected = 1e3 * bend * angle * angle / 8.0 * cosine;
        let extreme = |b: &Blocks| if bend > 0.0 { b.list[number].thickest.0 } else { b.list[number].thinnest.0 };
        let computed = blocks.as_ref().map_or(f64::NAN, extreme);
        let name = format!("circle 4 mm beside, short block at {:.2} deg", middle.to_degrees());
        let values = (expected, 1e6 * computed, "um");
        // x'' changes over the block by its angle, to either side alike.
        row(name, "largest error", values, Tolerance::Relative(4.0 * angle), "x''*dphi^2/8*cos; tolerance 4*dphi")
    };
    [60, 130, 300, 500].map(case).to_vec()
}
