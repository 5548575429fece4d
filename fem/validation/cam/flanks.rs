//! A straight flank in a block that lies evenly about its foot, and the fewest blocks on it.

use super::rig::*;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [one_block(), fewest(), lengths()].concat()
}

/// Half the flank and its distance from the axis, mm.
const HALF: f64 = 20.0;
const FOOT: f64 = 14.0;

/// The wheel's centre runs the concentric arc through its places over the ends of the flank. The envelope is
/// a concentric arc too, the rest imprints of the wheel at the ends.
fn one_block() -> Vec<Case> {
    let case = |wheel: f64, x: f64| {
        let slide = HALF.hypot(FOOT + wheel);
        let envelope = slide - wheel;
        let inside = x <= envelope * HALF / slide;
        let expected = match inside {
            true => (envelope * envelope - x * x).sqrt() - FOOT,
            false => wheel - (wheel * wheel - (HALF - x).powi(2)).sqrt(),
        };
        let program = "angle = \"1 deg\"\ncam_speed = \"20 rpm\"";
        let computed = usual(&cam(&stadium(", blocks = 1"), wheel, program, ""), FOOT.atan2(x).to_degrees());
        let what = if inside { "envelope" } else { "imprint" };
        let name = format!("flank in one block, wheel {wheel} mm, {what} at {x} mm");
        micro(name, (1e3 * expected, computed), ROUND_OFF, "circles")
    };
    let wide = [0.0, 1.5, 5.0, 10.0, 15.0].map(|x| case(175.0, x));
    let narrow = [0.0, 3.0, 9.0, 12.0, 19.0].map(|x| case(20.0, x));
    [wide, narrow].concat()
}

/// Envelope and imprints of all blocks are together as long as the profile, 80 mm and two half circles of 14 mm, in
/// whatever parts: few blocks leave long imprints, many leave ones shorter than the sampling.
fn lengths() -> Vec<Case> {
    let around = 4.0 * HALF + std::f64::consts::TAU * FOOT;
    let case = |number: usize| {
        let program = format!("blocks = {number}\ncam_speed = \"20 rpm\"");
        let cam = cam(&stadium(""), 175.0, &program, "");
        let told = blocks(&cam).map_or(f64::NAN, |r| r.list.iter().map(|b| 1e3 * (b.shaped + b.imprint)).sum());
        // Borders are found to a few millionths of a block, one or two in each.
        let tolerance = Tolerance::Relative(1e-5);
        let values = (around, told, "mm");
        row(format!("{number} blocks"), "envelope and imprints", values, tolerance, "the length of the profile")
    };
    [18, 60, 360].map(case).to_vec()
}

/// A flank that one block grinds to just within the tolerance, and to just beyond it; the arcs are concentric
/// to no one, and divided as they need.
fn fewest() -> Vec<Case> {
    let slide = HALF.hypot(FOOT + 175.0);
    let error = 1e3 * (slide - FOOT - 175.0);
    let case = |(part, expected): (f64, f64)| {
        let program = format!("tolerance = \"{} um\"\ncam_speed = \"20 rpm\"", part * error);
        let cam = cam(&stadium(""), 175.0, &program, "");
        let on_flank = |cam: Cam| {
            let setup = cam.setup();
            let end = setup.profile.joints()[1];
            setup.program.places.iter().filter(|s| **s > 0.0 && **s <= end * (1.0 + 1e-12)).count() as f64
        };
        let values = (expected, cam.map_or(f64::NAN, on_flank), "-");
        let name = format!("flank within {part} of the error of one block");
        row(name, "blocks", values, Tolerance::Absolute(0.5), "x(end) - x(foot)")
    };
    [(1.0001, 1.0), (0.9999, 2.0)].map(case).to_vec()
}
