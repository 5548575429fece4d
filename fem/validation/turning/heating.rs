//! The heated shaft against the series of its eigenfunctions.

use super::rig::*;
use crate::validation::{Case, Tolerance};

/// Ø40 × 500 mm at 0.2 mm/rev and 600 rpm: 2 mm/s.
const HEATED: &str = "[workpiece-heating]\npower = \"80 W\"\nconvection = \"25 W/m^2/K\"";

pub fn cases() -> Vec<Case> {
    // The solver is asked for 1e-4 of the largest rise; near the start the rise itself is smaller, so the
    // tolerance is absolute.
    let reach = |expected: f64| Tolerance::Absolute(1e-4 * expected.abs());
    let largest = error_at(0.0, 0.5);
    let heated = uniform("centres", HEATED);
    let forward = lathe(
        &UNIFORM.replace("HELD", "centres").replace("radial_force", "from = \"100 mm\", to = \"400 mm\", radial_force"),
        HEATED,
    );
    let at = |name: String, pair: (f64, f64)| {
        let source = "cosine series, insulated rod with convection";
        row(name, "diameter error", (pair.0, pair.1, "m"), reach(largest), source)
    };
    let whole = [
        (0.499, "1 mm after the start"),
        (0.45, "x = 0.9 L"),
        (0.25, "mid-span"),
        (0.02, "x = 0.04 L"),
        (0.0, "end of the cut"),
    ];
    let part = [(0.102, "2 mm after the start"), (0.3, "x = 0.6 L")];
    let whole = whole.map(|(x, place)| at(format!("heated shaft, {place}"), (error_at(x, 0.5), shift(&heated, 1, x))));
    let part = part.map(|(x, place)| {
        at(format!("heated from 0.2 L to 0.8 L, {place}"), (error_at(x, 0.1), shift(&forward, 1, x)))
    });
    whole.into_iter().chain(part).collect()
}

/// ΔD = −α·D·θ for the uniform shaft with the tool at x, having started at `from`; m.
fn error_at(x: f64, from: f64) -> f64 {
    -11.5e-6 * 0.04 * 80.0 * rise(x, from)
}

/// θ(x) per W: Σ cos(nπx/L)·∫cos(nπx_tool(s)/L)·e^(−(aω² + β)(t − s)) ds, each term in closed form, and the
/// tail of the terms' mean value by its integral.
fn rise(x: f64, from: f64) -> f64 {
    const TERMS: u32 = 200_000;
    let (length, diameter, speed) = (0.5, 0.04f64, 2e-3);
    let section = std::f64::consts::PI * diameter * diameter / 4.0;
    let capacity = 7850.0 * 470.0 * section;
    let diffusivity = 50.0 / (7850.0 * 470.0);
    let beta = 25.0 * std::f64::consts::PI * diameter / capacity;
    let (time, velocity) = ((x - from).abs() / speed, speed * (x - from).signum());
    let mut sum = -(-beta * time).exp_m1() / beta;
    for n in 1..=TERMS {
        let w = f64::from(n) * std::f64::consts::PI / length;
        // ∫₀ᵗ e^(−(re + i·im)·s) ds, turned by e^(iwx).
        let (re, im) = (diffusivity * w * w + beta, w * velocity);
        let decay = (-re * time).exp();
        let (top_re, top_im) = (1.0 - decay * (im * time).cos(), decay * (im * time).sin());
        let size = re * re + im * im;
        let (i_re, i_im) = ((top_re * re + top_im * im) / size, (top_im * re - top_re * im) / size);
        let (cosine, sine) = ((w * x).cos(), (w * x).sin());
        sum += 2.0 * cosine * (cosine * i_re - sine * i_im);
    }
    let w = (f64::from(TERMS) + 0.5) * std::f64::consts::PI / length;
    // cos² is 1/2 in the mean, and 1 at an end of the rod.
    let weight = if x == 0.0 || x == length { 2.0 } else { 1.0 };
    let tail = weight * (speed / (diffusivity * w)).atan() / speed * length / std::f64::consts::PI;
    (sum + tail) / (capacity * length)
}
