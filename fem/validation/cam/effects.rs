//! Effects of the grinder, computed by hand.

use std::f64::consts::TAU;

use super::rig::*;
use crate::validation::{Case, Tolerance};

/// The speed of the programme, rad/s.
const SPEED: f64 = 20.0 * TAU / 60.0;
const STEPS: &str = "blocks = 3600\ncam_speed = \"20 rpm\"";

pub fn cases() -> Vec<Case> {
    [round(), turned(), backlash(), deflection()].concat()
}

/// On a concentric circle of 14 mm.
fn round() -> Vec<Case> {
    let at = |effects: &str| usual(&cam(&circle(14.0, 0.0, true), 175.0, STEPS, effects), 123.0);
    let above = 1e3 * (189.0f64.hypot(0.5) - 189.0);
    let cases = [
        ("wheel worn by 25 um", 25.0, "[wheel-wear]\nloss = \"25 um\"", "R - loss"),
        ("circle about the axis, slide late", 0.0, "[servo-lag]\ntime = \"9 ms\"", "a circle turned in itself"),
        ("concentric circle, play", 0.0, "[infeed-backlash]\ngap = \"30 um\"", "the slide dwells"),
        ("wheel 0.5 mm above", above, "[centre-height]\nheight = \"500 um\"", "sqrt(x^2 + h^2)"),
        ("wheel 0.5 mm below", above, "[centre-height]\nheight = \"-500 um\"", "sqrt(x^2 + h^2)"),
    ];
    cases.map(|(name, expected, effects, source)| micro(name, (expected, at(effects)), ROUND_OFF, source)).to_vec()
}

/// A circle of 20 mm, 4 mm beside the axis, turned by `angle` about it: what it stands off along the normal
/// at a polar angle, um.
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
    let angle = SPEED * 8e-3;
    let case = |(name, turned, degrees, speed, is_reversed): (&str, f64, f64, f64, bool)| {
        let values = (turned_circle(turned, degrees), deviation(&late, degrees, speed, is_reversed));
        micro(name, values, tolerance, "a circle turned by omega*time; tolerance from the blocks")
    };
    let cases = [
        ("slide late, at 90 deg", angle, 90.0, 1.0, false),
        ("slide late, at 200 deg", angle, 200.0, 1.0, false),
        ("slide late, half the speed", 0.5 * angle, 90.0, 0.5, false),
        ("slide late, programme reversed", -angle, 90.0, 1.0, true),
    ];
    cases.map(case).to_vec()
}

/// The cam of the source rises over its nose to the concentric arc of 24 mm, and falls to that of 14 mm.
fn backlash() -> Vec<Case> {
    let played = seed(&[], "[infeed-backlash]\ngap = \"12 um\"");
    let case = |(name, expected, degrees, is_reversed): (&str, f64, f64, bool)| {
        let computed = deviation(&played, degrees, 1.0, is_reversed);
        micro(name, (expected, computed), ROUND_OFF, "play: half of it behind the last motion")
    };
    // From its end the programme rises to the same arc by the other side.
    let cases = [
        ("dwell after a rise, play", -6.0, 0.0, false),
        ("dwell after a fall, play", 6.0, 120.0, false),
        ("dwell after a rise, programme reversed", -6.0, 0.0, true),
        ("dwell after a fall, programme reversed", 6.0, 120.0, true),
    ];
    cases.map(case).to_vec()
}

fn deflection() -> Vec<Case> {
    let soft = "[grinding-deflection]\nstiffness = \"4 N/um\"";
    let concentric = cam(&circle(14.0, 0.0, true), 175.0, STEPS, soft);
    let fed = cam(&stadium(""), 175.0, "step = \"0.05 mm\"\nfeed = \"600 mm/min\"", soft);
    let flank = cam(&stadium(""), 175.0, STEPS, soft);
    let case = |name: &str, feed: f64, computed: f64, tolerance| {
        // F = 10 N/(mm²/s)·0.02 mm·v, over 4 N/um.
        micro(name, (10.0 * 0.02 * feed / 4.0, computed), tolerance, "F = force_per_rate*stock*feed")
    };
    let blocks = Tolerance::Absolute(0.2);
    let slower = deviation(&concentric, 70.0, 0.5, false);
    vec![
        case("concentric circle gives way", 14.0 * SPEED, usual(&concentric, 70.0), ROUND_OFF),
        case("the same at half the speed", 7.0 * SPEED, slower, ROUND_OFF),
        // At the foot |W|²/(W·n) = 189 mm.
        case("flank gives way at its foot", 189.0 * SPEED, usual(&flank, 90.0), blocks),
        // At (34, 0) mm, on a circle of 14 mm, the wheel's centre stands at 209 mm.
        case("arc gives way", SPEED * 209.0 * 14.0 / 189.0, usual(&flank, 0.0), blocks),
        case("flank at a feed of 10 mm/s", 10.0, usual(&fed, 90.0), blocks),
    ]
}
