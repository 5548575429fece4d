//! The curve that the path of the nose makes along the shaft, told by the invariants of a conic.
//!
//! A nose that leaves the axis by straight lines across and up makes y² = (D/2 + Δy)² + Δz², a conic ax² − y² + 2dx +
//! f = 0 with I₁ = d² − a·f and I₂ = −a [seed 002 (2)–(5)]. I₂ < 0 says hyperbola where I₁ ≠ 0, and a pair of lines, a
//! cone, where I₁ = 0. Guideways that are not straight leave no conic, and nothing is told of them.

use super::super::machine::{Machine, Moment};
use crate::process::Figure;
use crate::units::{AREA, NUMBER};

/// Part of its own rise by which y² may leave a parabola, and part of a·f that is no I₁: what round-off makes of them.
const ROUND_OFF: f64 = 1e-7;

/// The figure of a lathe whose guideways rise or fall.
pub fn figure(machine: &Machine) -> Option<Figure> {
    let setup = &machine.setup;
    let (length, diameter) = (setup.length(), setup.diameter(0.0));
    // Of the first diameter, before the first cut, where nothing is worn and nothing warm.
    let begin = |x: f64| Moment { x, diameter, part: 1, time: 0.0, path: 0.0 };
    let is_lifted = machine.lifts.iter().any(|lift| lift(&begin(length)) != 0.0);
    let squared =
        |part: f64| (0.5 * (diameter + machine.nose_at(&begin(part * length)).error(diameter, 0.0).0)).powi(2);
    let (first, middle, last) = (squared(0.0), squared(0.5), squared(1.0));
    let (bend, rise) = (2.0 * (last - 2.0 * middle + first), 4.0 * middle - 3.0 * first - last);
    let leaves = |part: f64| (squared(part) - first - rise * part - bend * part * part).abs();
    let is_conic = [0.25, 0.75].into_iter().all(|part| leaves(part) < ROUND_OFF * bend);
    let (a, d) = (bend / (length * length), 0.5 * rise / length);
    let (i1, i2) = (d * d - a * first, -a);
    let word = if i1.abs() > ROUND_OFF * a * first { "hyperbola" } else { "lines" };
    let text = match word {
        "hyperbola" => "a hyperbola turned about the axis, a hyperboloid",
        _ => "a pair of lines turned about the axis, a cone",
    };
    let figure = Figure::new("conic", "path of the nose")
        .entry("conic", word)
        .unit("i1_unit", AREA)
        .quantity("i1", AREA, i1)
        .quantity("i2", NUMBER, i2)
        .line(format!("makes {text}: I1 = {:.4e} mm^2, I2 = {i2:.4e}", AREA.from_si(i1)));
    (is_lifted && is_conic).then_some(figure)
}
