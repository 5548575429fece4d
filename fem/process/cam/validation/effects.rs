//! What the grinder adds, by hand.

use std::f64::consts::TAU;

use super::rig::*;
use crate::process::{Case, Tolerance};

/// The speed of the programme, rad/s.
const SPEED: f64 = 20.0 * TAU / 60.0;
const STEPS: &str = "blocks = 3600\ncam_speed = \"20 rpm\"";

pub fn cases() -> Vec<Case> {
    [round(), turned(), backlash(), deflection()].concat()
}

fn error(name: &str, expected: f64, computed: f64, tolerance: Tolerance, source: &'static str) -> Case {
    row(name, "deviation", (expected, computed, "um"), tolerance, source)
}

/// On a concentric circle of 14 mm.
fn round() -> Vec<Case> {
    let at = |effects: &str| usual(&cam(&circle(14.0, 0.0, true), 175.0, STEPS, effects), 123.0);
    let above = 1e3 * (189.0f64.hypot(0.5) - 189.0);
    vec![
        error("wheel worn by 25 um", 25.0, at("[wheel-wear]\nloss = \"25 um\""), ROUND_OFF, "R - loss"),
        error(
            "circle about the axis, slide late",
            0.0,
            at("[servo-lag]\ntime = \"9 ms\""),
            ROUND_OFF,
            "a circle turned in itself",
        ),
        error("concentric circle, play", 0.0, at("[infeed-backlash]\ngap = \"30 um\""), ROUND_OFF, "the slide dwells"),
        error("wheel 0.5 mm above", above, at("[centre-height]\nheight = \"500 um\""), ROUND_OFF, "sqrt(x^2 + h^2)"),
        error("wheel 0.5 mm below", above, at("[centre-height]\nheight = \"-500 um\""), ROUND_OFF, "sqrt(x^2 + h^2)"),
    ]
}

/// A circle of 20 mm, 4 mm beside the axis, turned by `angle` about it: what it stands off along the normal at a polar angle, um.
fn turned_circle(angle: f64, degrees: f64) -> f64 {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let distance = 4.0 * cosine + (400.0 - 16.0 * sine * sine).sqrt();
    let n = [(distance * cosine - 4.0) / 20.0, distance * sine / 20.0];
    let d = [4.0 * (angle.cos() - 1.0), 4.0 * angle.sin()];
    let along = n[0] * d[0] + n[1] * d[1];
    1e3 * (along - 20.0 + (400.0 - d[0] * d[0] - d[1] * d[1] + along * along).sqrt())
}

fn turned() -> Vec<Case> {
    let late = cam(&circle(20.0, 4.0, true), 175.0, STEPS, "[servo-lag]\ntime = \"8 ms\"");
    // Blocks of a tenth of a degree err by x''·Δφ²/8, x'' below 4 mm.
    let tolerance = Tolerance::Absolute(2.0 * 4e3 * (TAU / 3600.0).powi(2) / 8.0);
    let source = "a circle turned by omega*time; tolerance from the blocks";
    let angle = SPEED * 8e-3;
    vec![
        error("slide late, at 90 deg", turned_circle(angle, 90.0), usual(&late, 90.0), tolerance, source),
        error("slide late, at 200 deg", turned_circle(angle, 200.0), usual(&late, 200.0), tolerance, source),
        error(
            "slide late, half the speed",
            turned_circle(0.5 * angle, 90.0),
            deviation(&late, 90.0, 0.5, false),
            tolerance,
            source,
        ),
        error(
            "slide late, programme reversed",
            turned_circle(-angle, 90.0),
            deviation(&late, 90.0, 1.0, true),
            tolerance,
            source,
        ),
    ]
}

/// The cam of the source rises over its nose to the concentric arc of 24 mm, and falls to that of 14 mm.
fn backlash() -> Vec<Case> {
    let played = of_text(SEED, "[infeed-backlash]\ngap = \"12 um\"");
    let source = "play: half of it behind the last motion";
    let dwell = |name: &str, expected, degrees, is_reversed| {
        error(name, expected, deviation(&played, degrees, 1.0, is_reversed), ROUND_OFF, source)
    };
    vec![
        dwell("dwell after a rise, play", -6.0, 0.0, false),
        dwell("dwell after a fall, play", 6.0, 120.0, false),
        // From its end the programme rises to the same arc by the other side.
        dwell("dwell after a rise, programme reversed", -6.0, 0.0, true),
        dwell("dwell after a fall, programme reversed", 6.0, 120.0, true),
    ]
}

fn deflection() -> Vec<Case> {
    // F = 10 N/(mm²/s)·0.02 mm·v, over 4 N/um.
    let given_way = |feed: f64| 10.0 * 0.02 * feed / 4.0;
    let soft = "[grinding-deflection]\nstiffness = \"4 N/um\"";
    let concentric = cam(&circle(14.0, 0.0, true), 175.0, STEPS, soft);
    let fed = cam(&stadium(""), 175.0, "step = \"0.05 mm\"\nfeed = \"600 mm/min\"", soft);
    let flank = cam(&stadium(""), 175.0, STEPS, soft);
    let source = "F = force_per_rate*stock*feed";
    let blocks = Tolerance::Absolute(0.2);
    vec![
        error("concentric circle gives way", given_way(14.0 * SPEED), usual(&concentric, 70.0), ROUND_OFF, source),
        error(
            "the same at half the speed",
            given_way(7.0 * SPEED),
            deviation(&concentric, 70.0, 0.5, false),
            ROUND_OFF,
            source,
        ),
        // At the foot |W|²/(W·n) = 189 mm.
        error("flank gives way at its foot", given_way(189.0 * SPEED), usual(&flank, 90.0), blocks, source),
        // At (34, 0) mm, on a circle of 14 mm, the wheel's centre stands at 209 mm.
        error("arc gives way", given_way(SPEED * 209.0 * 14.0 / 189.0), usual(&flank, 0.0), blocks, source),
        error("flank at a feed of 10 mm/s", given_way(10.0), usual(&fed, 90.0), blocks, source),
    ]
}
