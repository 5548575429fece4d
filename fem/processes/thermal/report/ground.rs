//! The face that a passing wheel leaves on a plate which its heat bows.

use super::super::body::Body;
use super::super::boundary::{Boundary, Condition};
use super::scene::Scene;
use crate::process::Figure;
use crate::units::{LENGTH, MICRO};

/// The way of a wheel along the upper face.
#[derive(Clone, Copy, Debug)]
pub struct Wheel {
    /// m/s.
    pub speed: f64,
    /// Place at the start, m.
    pub from: f64,
    /// Length of the face, m.
    pub length: f64,
}

/// Where the face is hollow most, and how deep, once the plate is cold and flat again: `None` where no strip of heat
/// passes along the top.
pub fn figure(body: &Body, boundaries: &[Boundary], scene: &Scene) -> Option<Figure> {
    let bows = scene.bow.as_ref().filter(|_| body.has_sections())?;
    let wheel = boundaries.iter().find_map(|boundary| match boundary.condition {
        Condition::Moving { speed, from, .. } if boundary.edge == "top" => {
            Some(Wheel { speed, from, length: body.length() })
        }
        _ => None,
    })?;
    let (x, depth) = hollow(wheel, scene.times(), bows)?;
    let side = if depth > 0.0 { "hollow" } else { "high" };
    Some(
        Figure::new("ground", "ground face, when cold")
            .line(format!(
                "{side} by {:.3} at x = {:.1}, by the bow with which it was ground",
                MICRO.shown(depth.abs()),
                LENGTH.shown(x)
            ))
            .quantity("hollow", MICRO, depth)
            .quantity("x", LENGTH, x),
    )
}

/// Place (m) and depth (m) of the deepest hollow, given the bow (m) at times (s). The wheel grinds a plane: where
/// the plate is bowed up by b(t)·4ξ(1 − ξ), ξ = x/L, it takes as much more off, and the cold face lacks it [seed 002,
/// grinding of a prismatic part; ours: the bow as a parabola between the ends]. The growth of the height under the
/// wheel is left out.
pub fn hollow(wheel: Wheel, times: &[f64], bows: &[f64]) -> Option<(f64, f64)> {
    let passed = times.iter().zip(bows).map(|(time, bow)| {
        let x = wheel.from + wheel.speed * time;
        let share = x / wheel.length;
        (x, bow * 4.0 * share * (1.0 - share))
    });
    let on = passed.filter(|(x, _)| (0.0..=wheel.length).contains(x));
    on.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
}
