//! Straight sides at an angle, and their corners.

use super::rig::*;
use crate::validation::{Case, Tolerance};

/// Transient of a corner where the report of a side begins, mm: e^(−10) of v/Kv = 1/3 mm.
const CORNER: f64 = 4.54e-5 / 3.0;

pub fn cases() -> Vec<Case> {
    [offsets(), seed(), corners(), others()].concat()
}

/// v(Kvx − Kvy)/(2KvxKvy)·sin 2β outwards, counter-clockwise, β the direction of travel; clockwise the
/// opposite.
fn offsets() -> Vec<Case> {
    let machine = machine(&rectangle(30.0, 50.0), "[servo-mismatch]\nmismatch = 0.1");
    let (x, y): (f64, f64) = (50.0 * 1.05, 50.0 * 0.95);
    let mut cases = Vec::new();
    // The middles of the sides; the first is travelled at 120 deg.
    for (direction, sign) in WAYS.into_iter().zip([1.0, -1.0]) {
        for side in 0..4 {
            let (facing, travel) = (30.0 + 90.0 * f64::from(side), 120.0 + 90.0 * f64::from(side));
            let expected = sign / 60.0 * (x - y) / (2.0 * x * y) * f64::to_radians(2.0 * travel).sin();
            cases.push(micro(
                format!("gains apart by 0.1, side facing {facing} deg, {}", direction.word()),
                (expected, deviation(&machine, direction, facing)),
                1e-14,
                "seed 000",
            ));
        }
    }
    cases
}

/// The seed's square at 45°: sizes that differ by 0.1 mm.
fn seed() -> Vec<Case> {
    let text = "path = { shape = \"rectangle\", width = \"100 mm\", height = \"100 mm\", angle = \"45 deg\", feed = \"600 mm/min\" }\n\
                drives = { gain = \"50 /s\", lead = \"10 mm\" }\ntolerance = { deviation = \"0.025 mm\" }";
    let machine = machine(text, "[servo-mismatch]\nmismatch = 0.25");
    let rounding = Tolerance::Relative(0.25f64.powi(2) / 4.0 / (1.0 - 0.25f64.powi(2) / 4.0) * (1.0 + 1e-3));
    let source = "seed 000, 2*delta; tolerance m^2/4 of its rounding";
    let size = |name: &str| 1e-3 * figure_of(&machine, "sizes", &format!("/ccw/{name}"));
    vec![
        // Width lies between the sides that are travelled at 135 deg, height between those at 45 deg.
        row(
            "square at 45 deg, gains apart by 0.25",
            "error of the height, ccw",
            (0.05, size("height"), "mm"),
            rounding,
            source,
        ),
        row(
            "square at 45 deg, gains apart by 0.25",
            "error of the width, ccw",
            (-0.05, size("width"), "mm"),
            rounding,
            source,
        ),
        row(
            "square at 45 deg, 0.025 mm at 600 mm/min and 50 /s",
            "mismatch allowed",
            (0.25, figure_of(&machine, "tolerance", "/mismatch_allowed"), "-"),
            ROUND_OFF,
            "seed 000, dKv/Kv = 2*delta*Kv/v",
        ),
    ]
}

/// Equal servos round a right angle along (−e^(−t), t − 1 + e^(−t)), in v/Kv and 1/Kv from the corner on:
/// nearest where that is square to the way.
fn corners() -> Vec<Case> {
    let square = |t: f64| {
        let fade = (-t).exp();
        -fade * fade + (t - 1.0 + fade) * (1.0 - fade)
    };
    let (mut low, mut high) = (0.0, 4.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if square(middle) < 0.0 { low = middle } else { high = middle }
    }
    let nearest = (-low).exp().hypot(low - 1.0 + (-low).exp());
    let corner = |angle: f64| {
        let machine = machine(&rectangle(angle, 50.0), "");
        let expected = nearest / 3.0;
        row(
            format!("right angle at {angle} deg, v/Kv = 1/3 mm"),
            "distance of the tool from the corner",
            (expected, figure_of(&machine, "corners", "/largest"), "mm"),
            Tolerance::Relative(1e-9),
            "response of two equal servos to a corner",
        )
    };
    vec![corner(0.0), corner(30.0)]
}

fn others() -> Vec<Case> {
    let play = machine(&rectangle(0.0, 50.0), "[backlash-x]\ngap = \"8 um\"\n[backlash-y]\ngap = \"3 um\"");
    let square = machine(&rectangle(0.0, 50.0), "[squareness]\nangle = \"40 um/m\"");
    let scale = machine(&rectangle(0.0, 50.0), "[scale-mismatch]\nmismatch = \"40 um/m\"");
    let moved = machine(&rectangle(30.0, 50.0), "[centre-offset]\nx = \"5 um\"\ny = \"-9 um\"");
    let plain = machine(&rectangle(30.0, 50.0), "");
    let length = |name: &str, expected: f64, computed: f64, source| {
        row(name, "error of the size", (expected, computed, "um"), Tolerance::Absolute(2e3 * CORNER), source)
    };
    let side = |facing: f64| {
        let angle = f64::to_radians(facing);
        micro(
            format!("centre beside by (5, -9) um, side facing {facing} deg"),
            (5e-6 * angle.cos() - 9e-6 * angle.sin(), deviation(&moved, CCW, facing)),
            1e-14,
            "x*cos + y*sin of where the side faces",
        )
    };
    vec![
        length(
            "play of 8 um in x",
            -8.0,
            figure_of(&play, "sizes", "/cw/width"),
            "each side half a gap inside; tolerance the rest of the corners",
        ),
        length(
            "play of 3 um in y",
            -3.0,
            figure_of(&play, "sizes", "/ccw/height"),
            "each side half a gap inside; tolerance the rest of the corners",
        ),
        length(
            "x longer by 40 um/m, 80 mm",
            1.6,
            figure_of(&scale, "sizes", "/ccw/width"),
            "mismatch/2 of the size; tolerance the rest of the corners",
        ),
        length(
            "y shorter by 40 um/m, 50 mm",
            -1.0,
            figure_of(&scale, "sizes", "/ccw/height"),
            "mismatch/2 of the size; tolerance the rest of the corners",
        ),
        row(
            "y leans by 40 um/m",
            "tilt of the side facing 0 deg",
            (40.0, figure_of(&square, "sides", "/ccw/tilts/0"), "um/m"),
            Tolerance::Absolute(6e6 * CORNER / 50.0),
            "x += angle*y; tolerance the rest of the corner over the side",
        ),
        length(
            "y leans by 40 um/m, feed ccw",
            -2.0 * 40e-3 * 1000.0 / 60.0 / 50.0,
            figure_of(&square, "sizes", "/ccw/width"),
            "both sides are cut v/Kv late, where y is smaller by as much; tolerance the rest of the corners",
        ),
        length(
            "y leans by 40 um/m, feed cw",
            2.0 * 40e-3 * 1000.0 / 60.0 / 50.0,
            figure_of(&square, "sizes", "/cw/width"),
            "both sides are cut v/Kv late, where y is larger by as much; tolerance the rest of the corners",
        ),
        side(30.0),
        side(120.0),
        side(300.0),
        row(
            "lead of 10 mm on a side at 30 deg",
            "wave of x",
            (10.0 / 30f64.to_radians().cos(), figure_of(&plain, "waves", "/list/0/length"), "mm"),
            ROUND_OFF,
            "seed 000, pitch/cos(phi)",
        ),
        row(
            "lead of 10 mm on a side at 30 deg",
            "wave of y",
            (10.0 / 60f64.to_radians().cos(), figure_of(&plain, "waves", "/list/1/length"), "mm"),
            ROUND_OFF,
            "seed 000, pitch/cos(phi)",
        ),
    ]
}
