//! Two servos alone, and two unequal ones.

use super::rig::*;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [contraction(), mismatch(), seed()].concat()
}

/// R(1 − 1/√(1 + (v/RKv)²)), alike all around.
fn contraction() -> Vec<Case> {
    let mut cases = Vec::new();
    for (radius, feed, gain) in [(150.0, 1000.0, 50.0), (50.0, 3000.0, 30.0), (20.0, 6000.0, 25.0)] {
        let machine = machine(&circle(radius, feed, gain), "");
        let ratio: f64 = feed / 60.0 / (radius * gain);
        let name = format!("circle of {radius} mm at {feed} mm/min, {gain} /s");
        let exact = -1e-3 * radius * (1.0 - 1.0 / (1.0 + ratio * ratio).sqrt());
        cases.push(micro(name.clone(), (exact, deviation(&machine, CCW, 40.0)), 1e-15, "R(1 - 1/sqrt(1 + (v/RKv)^2))"));
        cases.push(row(
            name,
            "contraction",
            (1e-3 * radius * ratio * ratio / 2.0, -deviation(&machine, CW, 250.0), "m"),
            Tolerance::Relative(ratio * ratio),
            "v^2/(2*R*Kv^2); tolerance (v/RKv)^2",
        ));
    }
    cases
}

/// ±(v/2)·sin 2α·(1/Kvx − 1/Kvy) beside the contraction. Left out is (3/2)·m·R(v/RKv)²·cos 2α and less.
fn mismatch() -> Vec<Case> {
    let mut cases = Vec::new();
    let (radius, feed, gain): (f64, f64, f64) = (0.15, 1.0 / 60.0, 50.0);
    for mismatch in [0.1, -0.04] {
        let machine = machine(&circle(150.0, 1000.0, gain), &format!("[servo-mismatch]\nmismatch = {mismatch}"));
        let second = (feed / (radius * gain)).powi(2) * radius;
        for (direction, sign) in WAYS.into_iter().zip([1.0, -1.0]) {
            for angle in [45.0, 20.0, 110.0] {
                let lags = 1.0 / (gain * (1.0 + mismatch / 2.0)) - 1.0 / (gain * (1.0 - mismatch / 2.0));
                let expected = sign * feed / 2.0 * f64::to_radians(2.0 * angle).sin() * lags - second / 2.0;
                cases.push(micro(
                    format!("gains apart by {mismatch}, {} at {angle} deg", direction.word()),
                    (expected, deviation(&machine, direction, angle)),
                    2.0 * f64::abs(mismatch) * second,
                    "seed 000, with the sign of a circle; tolerance 2*m*R*(v/RKv)^2",
                ));
            }
        }
    }
    cases
}

/// The seed's own example: axes that differ by 0.1 mm, so 0.025 mm at 45°, 600 mm/min and 50/s allow gains
/// that differ by 25 %.
fn seed() -> Vec<Case> {
    let text = format!("{}tolerance = {{ deviation = \"0.025 mm\" }}\n", circle(100.0, 600.0, 50.0));
    let unequal = machine(&text, "[servo-mismatch]\nmismatch = 0.25");
    let diameters = |direction: &str| {
        let at = |i: usize| figure_of(&unequal, "diameters", &format!("/{direction}/{i}"));
        1e-3 * (at(1) - at(3))
    };
    // 1/Kvx − 1/Kvy is −m/Kv·1/(1 − m²/4).
    let rounding = Tolerance::Relative(0.25f64.powi(2) / 4.0 / (1.0 - 0.25f64.powi(2) / 4.0) * (1.0 + 1e-3));
    let source = "seed 000, dKv/Kv = 2*delta*Kv/v";
    let rounded = "seed 000, 4*delta, with the sign of a circle; tolerance m^2/4 of its rounding";
    vec![
        row(
            "0.025 mm at 600 mm/min and 50 /s",
            "mismatch allowed",
            (0.25, figure_of(&unequal, "tolerance", "/mismatch_allowed"), "-"),
            ROUND_OFF,
            source,
        ),
        row(
            "gains apart by 0.25",
            "diameter at 45 less at 135 deg, ccw",
            (-0.1, diameters("ccw"), "mm"),
            rounding,
            rounded,
        ),
        row(
            "gains apart by 0.25",
            "diameter at 45 less at 135 deg, cw",
            (0.1, diameters("cw"), "mm"),
            rounding,
            rounded,
        ),
        row(
            "gains apart by 0.25",
            "feed that uses up 0.025 mm",
            (600.0, figure_of(&unequal, "tolerance", "/feed_by_mismatch"), "mm/min"),
            rounding,
            rounded,
        ),
        row(
            "0.025 mm on 100 mm at 50 /s",
            "feed at which the contraction uses it up",
            (
                (2.0 * 0.025 / 100.0f64).sqrt() * 100.0 * 50.0 * 60.0,
                figure_of(&unequal, "tolerance", "/feed_by_contraction"),
                "mm/min",
            ),
            Tolerance::Relative(0.025 / 100.0),
            "v = R*Kv*sqrt(2*delta/R); tolerance delta/R",
        ),
        row(
            "1000 mm/min and 50 /s",
            "following error",
            (1.0 / 3.0, figure_of(&machine(&circle(150.0, 1000.0, 50.0), ""), "servo", "/lag"), "mm"),
            ROUND_OFF,
            "seed 000, gain of a servo: v/Kv",
        ),
    ]
}
