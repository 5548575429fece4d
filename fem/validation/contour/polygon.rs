//! A triangle with legs along the axes: two acute corners and a side at an angle.

use super::rig::*;
use crate::validation::{Case, Tolerance};

/// Legs of 80 and 60 mm, the right corner first, at 1000 mm/min with 50 /s: v/Kv is 1/3 mm.
const TRIANGLE: &str = r#"
    path = { shape = "polygon", feed = "1000 mm/min", corners = [
        { x = "-20 mm", y = "-20 mm" }, { x = "60 mm", y = "-20 mm" }, { x = "-20 mm", y = "40 mm" },
    ] }
    drives = { gain = "50 /s", lead = "10 mm" }
"#;
/// Polar angles at which a ray meets the middle of the hypotenuse, (20, 10) mm, the leg along x and that along y, deg.
const HYPOTENUSE: f64 = 26.565_051_177_077_99;
const ALONG_X: f64 = 270.0;
const ALONG_Y: f64 = 180.0;

pub fn cases() -> Vec<Case> {
    [offsets(), corners()].concat()
}

/// The hypotenuse is travelled along (-0.8, 0.6) and faces (0.6, 0.8).
fn offsets() -> Vec<Case> {
    let unequal = machine(TRIANGLE, "[servo-mismatch]\nmismatch = 0.1");
    let loose = machine(TRIANGLE, "[backlash-x]\ngap = \"8 um\"");
    let (x, y): (f64, f64) = (50.0 * 1.05, 50.0 * 0.95);
    let off = |name: &str, machine: &Option<Machine>, direction, at, expected, source| {
        micro(name.to_string(), (expected, deviation(machine, direction, at)), 1e-14, source)
    };
    // sin 2a of a direction with the cosine -0.8 and the sine 0.6.
    let delta = 1.0 / 60.0 * (x - y) / (2.0 * x * y) * (2.0 * -0.8 * 0.6);
    let seed = "seed 000";
    let play = "half a gap behind, along x, on a side that faces (0.6, 0.8)";
    let rests = "x rests half a gap inside";
    vec![
        off("triangle, gains apart by 0.1, hypotenuse, ccw", &unequal, CCW, HYPOTENUSE, delta, seed),
        off("triangle, gains apart by 0.1, hypotenuse, cw", &unequal, CW, HYPOTENUSE, -delta, seed),
        off("triangle, gains apart by 0.1, leg along x", &unequal, CCW, ALONG_X, 0.0, seed),
        off("triangle, play of 8 um in x, hypotenuse, ccw", &loose, CCW, HYPOTENUSE, 4e-6 * 0.6, play),
        off("triangle, play of 8 um in x, hypotenuse, cw", &loose, CW, HYPOTENUSE, -4e-6 * 0.6, play),
        off("triangle, play of 8 um in x, leg along y, ccw", &loose, CCW, ALONG_Y, -4e-6, rests),
        off("triangle, play of 8 um in x, leg along y, cw", &loose, CW, ALONG_Y, -4e-6, rests),
    ]
}

/// Behind a corner at which the way turns from u to w equal servos are at (s - 1 + e^-s) w - e^-s u, in v/Kv and 1/Kv:
/// nearest to it where that is square to the velocity (1 - e^-s) w + e^-s u.
fn corners() -> Vec<Case> {
    let nearest = |cosine: f64| {
        let parts = |s: f64| [s - 1.0 + (-s).exp(), -(-s).exp()];
        let speeds = |s: f64| [1.0 - (-s).exp(), (-s).exp()];
        // The product of two vectors by their parts along w and u.
        let product = |[a, b]: [f64; 2], [c, d]: [f64; 2]| a * c + b * d + (a * d + b * c) * cosine;
        let (mut low, mut high) = (0.0, 4.0);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if product(parts(middle), speeds(middle)) < 0.0 { low = middle } else { high = middle }
        }
        product(parts(low), parts(low)).sqrt() / 3.0
    };
    let machine = machine(TRIANGLE, "");
    let passed = |name: &str, expected: f64, key: &str| {
        row(
            name,
            "distance of the tool from the corner",
            (expected, figure_of(&machine, "corners", key), "mm"),
            Tolerance::Relative(1e-9),
            "response of two equal servos to a corner",
        )
    };
    vec![
        // atan 60/80: the way turns by 180 deg less that, of the cosine -0.8.
        passed("corner of 36.87 deg, v/Kv = 1/3 mm", nearest(-0.8), "/largest"),
        passed("right corner among acute, v/Kv = 1/3 mm", nearest(0.0), "/smallest"),
    ]
}
