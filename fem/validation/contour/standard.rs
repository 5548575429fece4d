//! The figures of ISO 230-4 on shapes whose figures are known.

use super::rig::*;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    let text = circle(150.0, 1000.0, STIFF);
    // Ellipses of 3 um: G = 6 um about a circle of the programmed radius.
    let leaning = machine(&text, "[squareness]\nangle = \"40 um/m\"");
    // Counter-clockwise an ellipse of 3 um at 45 deg, clockwise one at 135 deg.
    let lagging = machine(&circle(150.0, 1000.0, 50.0), "[servo-mismatch]\nmismatch = 0.02");
    let beside = machine(&text, "[centre-offset]\nx = \"3 um\"\ny = \"4 um\"");
    let plain = machine(&circle(150.0, 1000.0, 50.0), "");
    let play = machine(&text, "[backlash-x]\ngap = \"8 um\"");
    let contraction = 1e3 * 150.0 * (1.0f64 / 450.0).powi(2) / 2.0;
    let um = |name: &str, quantity, (expected, computed), allowed: f64| {
        row(name, quantity, (expected, computed, "um"), Tolerance::Absolute(allowed), "ISO 230-4, by the shape")
    };
    let ellipse = "ellipse of 3 um";
    // 1/6 mm·m/(1 − m²/4).
    let lag = 1e3 / 6.0 * 0.02 / (1.0 - 1e-4);
    // Second order: 2·m·R(v/RKv)² either way.
    let second = 4.0 * 0.02 * 1e3 * 150.0 / 450f64.powi(2);
    let offset = "circle beside by (3, 4) um";
    // Largest and smallest stand at 53.13 deg, and the nearest point predicted at 53 deg.
    let between = 5.0 * 0.5f64.to_radians().powi(2) / 2.0 + 1e-6;
    vec![
        um(ellipse, "G, ccw", (6.0, figure_of(&leaning, "circular_deviation", "/G_ccw")), 1e-3),
        um(ellipse, "G(b)", (6.0, figure_of(&leaning, "circular_deviation", "/G_b")), 1e-3),
        um(ellipse, "F max, cw", (3.0, figure_of(&leaning, "radial_deviation", "/F_max_cw")), 1e-3),
        um(ellipse, "F min, cw", (-3.0, figure_of(&leaning, "radial_deviation", "/F_min_cw")), 1e-3),
        um(
            "ellipses across each other",
            "G, ccw",
            (2.0 * lag, figure_of(&lagging, "circular_deviation", "/G_ccw")),
            second,
        ),
        um(
            "ellipses across each other",
            "G(b)",
            (2.0 * lag, figure_of(&lagging, "circular_deviation", "/G_b")),
            second,
        ),
        um(offset, "G, ccw", (0.0, figure_of(&beside, "circular_deviation", "/G_ccw")), 1e-3),
        um(offset, "F max, ccw", (5.0, figure_of(&beside, "radial_deviation", "/F_max_ccw")), between),
        um(offset, "F min, ccw", (-5.0, figure_of(&beside, "radial_deviation", "/F_min_ccw")), between),
        um(
            "equal servos",
            "D",
            (-contraction, figure_of(&plain, "mean_radial_deviation", "/D")),
            contraction / 450f64.powi(2),
        ),
        um("equal servos", "G(b)", (0.0, figure_of(&plain, "circular_deviation", "/G_b")), 1e-9),
        um(
            "play of 8 um in x",
            "G, cw",
            (8.0, figure_of(&play, "circular_deviation", "/G_cw")),
            8.0 * (1.0 - 1f64.to_radians().cos()) + 1e-3,
        ),
    ]
}
