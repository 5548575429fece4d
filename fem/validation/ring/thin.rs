//! Rings as thin as a hoop, which bend as curved beams, and rings under even pressure.

use std::f64::consts::{PI, TAU};

use super::rig::*;
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [hoops(), pairs(), lame()].concat()
}

/// Wall and mean radius of the hoop, m.
const WALL: f64 = 2e-4;
const RADIUS: f64 = 0.05;

/// Inward at a load (FR³/2EI)·[(β/2 + sin2β/4)/sin²β − 1/β], outward midway (FR³/4EI)·[2/β − 1/sinβ −
/// β·cosβ/sin²β], β = π/n.
fn hoops() -> Vec<Case> {
    let inertia = 0.02 * WALL.powi(3) / 12.0;
    // Of 1 N: hoops are soft. Elements must be short to bend a thin wall, and one across it is enough.
    let scale = RADIUS.powi(3) / (210e9 * inertia);
    let mut cases = Vec::new();
    for n in [2usize, 3, 4, 6] {
        let beta = PI / n as f64;
        let (sine, cosine) = beta.sin_cos();
        let inward = 0.5 * ((0.5 * beta + 0.25 * (2.0 * beta).sin()) / (sine * sine) - 1.0 / beta);
        let outward = 0.25 * (2.0 / beta - 1.0 / sine - beta * cosine / (sine * sine));
        let (outer, inner) = (2e3 * RADIUS + 1e3 * WALL, 2e3 * RADIUS - 1e3 * WALL);
        let text = ring(inner, n)
            .replace("\"100 mm\"", &format!("\"{outer} mm\""))
            .replace("3 kN", "1 N")
            .replace("circumferential = 360, radial = 6", "circumferential = 1080, radial = 1");
        let hoop = chuck(&text, "");
        // The formulas leave out that the hoop also shortens and shears, which is of the order of (h/R)²/12
        // in FR³/EI.
        let left_out = |coefficient: f64| Tolerance::Relative(2.0 * (WALL / RADIUS).powi(2) / 12.0 / coefficient);
        let source = "thin ring under n loads (Roark, circular rings, case 7); shortening and shear left out";
        let name = format!("hoop of R/250 wall, {n} line loads");
        let at = -clamped(&hoop, 0.0);
        cases.push(row(name.clone(), "inward at a load", (inward * scale, at, "m"), left_out(inward), source));
        let midway = clamped(&hoop, beta);
        cases.push(row(name, "outward midway", (outward * scale, midway, "m"), left_out(outward), source));
    }
    cases
}

/// Two pairs of 1.3 and 0.7 N: inward at the stronger one, what its own pair does less what the other does midway.
fn pairs() -> Vec<Case> {
    let beta = 0.5 * PI;
    // β = π/2 in the formulas of hoops.
    let (inward, outward) = (PI / 8.0 - 1.0 / PI, 1.0 / PI - 0.25);
    let scale = RADIUS.powi(3) / (210e9 * 0.02 * WALL.powi(3) / 12.0);
    let text = ring(2e3 * RADIUS - 1e3 * WALL, 4)
        .replace("\"100 mm\"", &format!("\"{} mm\"", 2e3 * RADIUS + 1e3 * WALL))
        .replace("3 kN", "1 N")
        .replace("circumferential = 360, radial = 6", "circumferential = 1080, radial = 1");
    let hoop = chuck(&text, "[jaw-imbalance]\ndifference = \"60 %\"");
    let case = |(quantity, angle, own, other): (&'static str, f64, f64, f64)| {
        let expected = own * inward - other * outward;
        let left_out = 2.0 * (WALL / RADIUS).powi(2) / 12.0 / expected.abs();
        let pair = (expected * scale, -clamped(&hoop, angle), "m");
        let source = "thin ring under two opposite loads (Roark, circular rings, case 1), twice";
        row("hoop of R/250 wall, pairs of 1.3 and 0.7 N", quantity, pair, Tolerance::Relative(left_out), source)
    };
    [("inward at the stronger pair", 0.0, 1.3, 0.7), ("inward at the weaker pair", beta, 0.7, 1.3)].map(case).to_vec()
}

/// Jaws that press all around: u_r(Ri) = −2p·Ro²·Ri/(E·(Ro² − Ri²)).
fn lame() -> Vec<Case> {
    let case = |(bore, jaws): (f64, usize)| {
        let (outer, inner) = (0.05f64, 5e-4 * bore);
        let pressure = 3000.0 * jaws as f64 / (TAU * outer * 0.02);
        let expected = -2.0 * pressure * outer * outer * inner / (210e9 * (outer * outer - inner * inner));
        let arc = format!("[jaw-contact-arc]\narc = \"{} deg\"", 360.0 / jaws as f64);
        let computed = clamped(&chuck(&ring(bore, jaws), &arc), 0.4);
        // Six 8-node elements over a thick wall: their error falls with the fourth power of their size.
        let wall_part = (outer / inner).ln() / 6.0;
        row(
            format!("{jaws} jaws all around, bore {bore} mm of 100"),
            "radial displacement",
            (expected, computed, "m"),
            Tolerance::Relative(wall_part.powi(4).max(1e-9)),
            "Lame, outer pressure; tolerance (ln(Ro/Ri)/6)^4",
        )
    };
    [(50.0, 3), (70.0, 4), (84.0, 3), (95.0, 2)].map(case).to_vec()
}
