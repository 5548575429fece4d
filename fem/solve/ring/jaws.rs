//! Jaws: forces on the outer circle, spread evenly over a contact arc.
//!
//! ```text
//!   fₐ = −∫ (F/w) Nₐ(s(θ)) (cos θ, sin θ)ᵀ dθ  over the arc of full angle w about φ
//!   fₐ = −F Nₐ(s(φ)) (cos φ, sin φ)ᵀ           for w = 0, a line load
//! ```
//!
//! s(θ) is the parameter of the side at the polar angle θ, so that every part of the load acts through the
//! centre and the sum of the forces is exact, wherever the arc begins and ends within the sides.

use std::f64::consts::TAU;

use super::circle::{Arc, all_around, arcs};
use crate::element::plane::quadrature::LINE_5;
use crate::mesh::{Mesh, MeshError, OUTSIDE, Side};
use crate::solve::elastic::Loads;

/// The load of one jaw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactArc {
    /// Angle of its middle φ, rad.
    pub angle: f64,
    /// Full angle w over which it presses, rad; 0 for a line load.
    pub width: f64,
    /// Radial force F = ∫ p dA, N, positive inwards.
    pub force: f64,
}

/// The part of a body's border that jaws can press on: sides on a circle about the origin.
#[derive(Clone, Debug)]
pub struct JawCircle {
    arcs: Vec<Arc>,
}

/// Angle (rad) by which a jaw may stand beyond the sides: rounding of coordinates.
const BEYOND: f64 = 1e-6;

impl JawCircle {
    /// These sides, which lie on a circle about the origin.
    pub fn new(mesh: &Mesh, sides: &[Side]) -> Self {
        Self { arcs: arcs(mesh, sides) }
    }

    /// Whether the sides are there wherever a jaw presses.
    pub fn carries(&self, jaw: &ContactArc) -> bool {
        if jaw.width == 0.0 {
            return self.arcs.iter().any(|arc| nearest(arc, jaw.angle).0 < BEYOND);
        }
        let covered: f64 = self.arcs.iter().flat_map(|arc| parts(arc, jaw)).map(|(low, high)| high - low).sum();
        covered > jaw.width - BEYOND
    }

    /// Adds the force of a jaw.
    ///
    /// # Errors
    /// A width outside [0, 2π].
    pub fn press(&self, loads: &mut Loads, jaw: &ContactArc) -> Result<(), MeshError> {
        if !(jaw.width >= 0.0 && jaw.width <= TAU) {
            return Err(MeshError::Parameter {
                quantity: "contact arc (rad)",
                range: "0 to 2π".to_owned(),
                value: jaw.width,
            });
        }
        if jaw.width == 0.0 {
            let near = self.arcs.iter().map(|arc| (arc, nearest(arc, jaw.angle)));
            if let Some((arc, (_, beyond))) = near.min_by(|a, b| a.1.0.total_cmp(&b.1.0)) {
                push(loads, arc, beyond, jaw.force);
            }
            return Ok(());
        }
        for arc in &self.arcs {
            for (low, high) in parts(arc, jaw) {
                press(loads, arc, jaw, [low, high]);
            }
        }
        Ok(())
    }
}

/// Adds the forces of the jaws on the sides [`OUTSIDE`].
///
/// # Errors
/// The mesh has no such sides, or they do not close around the origin; a width outside [0, 2π].
pub fn add_jaws(loads: &mut Loads, mesh: &Mesh, jaws: &[ContactArc]) -> Result<(), MeshError> {
    add_jaws_on(OUTSIDE, loads, mesh, jaws)
}

/// Adds the forces of the jaws on sides of this name.
///
/// # Errors
/// As [`add_jaws`].
pub fn add_jaws_on(name: &str, loads: &mut Loads, mesh: &Mesh, jaws: &[ContactArc]) -> Result<(), MeshError> {
    let circle = JawCircle { arcs: all_around(mesh, name)? };
    jaws.iter().try_for_each(|jaw| circle.press(loads, jaw))
}

/// Adds a radial force of `density`(θ) newtons per radian, positive inwards, all around the sides
/// [`OUTSIDE`].
#[cfg(test)]
pub(super) fn add_radial(loads: &mut Loads, mesh: &Mesh, density: impl Fn(f64) -> f64) -> Result<(), MeshError> {
    for arc in &all_around(mesh, OUTSIDE)? {
        let half = 0.5 * arc.span.abs();
        for (place, weight) in LINE_5 {
            let beyond = half * (1.0 + place);
            push(loads, arc, beyond, density(arc.low() + beyond) * half * weight);
        }
    }
    Ok(())
}

/// Distance (rad) of an angle from a side, and the nearest place on the side as an angle beyond its lower
/// end.
fn nearest(arc: &Arc, angle: f64) -> (f64, f64) {
    let (span, beyond) = (arc.span.abs(), arc.beyond(angle));
    let (above, below) = (beyond - span, TAU - beyond);
    match above <= 0.0 {
        true => (0.0, beyond),
        false if above < below => (above, span),
        false => (below, 0.0),
    }
}

/// The parts of a side on which a jaw presses, as angles beyond the lower end of the side; the jaw may begin
/// below the side and reach it after a turn.
fn parts(arc: &Arc, jaw: &ContactArc) -> impl Iterator<Item = (f64, f64)> {
    let (span, width) = (arc.span.abs(), jaw.width);
    let from = arc.beyond(jaw.angle - 0.5 * width);
    [from - TAU, from].into_iter().map(move |from| (from.max(0.0), (from + width).min(span))).filter(|(l, h)| h > l)
}

/// Adds the part of a jaw's pressure that lies between two angles of a side.
fn press(loads: &mut Loads, arc: &Arc, jaw: &ContactArc, [low, high]: [f64; 2]) {
    let half = 0.5 * (high - low);
    for (place, weight) in LINE_5 {
        push(loads, arc, low + half * (1.0 + place), jaw.force / jaw.width * half * weight);
    }
}

/// Adds an inward force at an angle `beyond` the lower end of a side.
fn push(loads: &mut Loads, arc: &Arc, beyond: f64, force: f64) {
    let (sine, cosine) = (arc.low() + beyond).sin_cos();
    let shapes = arc.shapes(arc.beyond_start(beyond));
    for (&node, shape) in arc.nodes.as_slice().iter().zip(shapes) {
        loads.add_force(node as usize, [-force * shape * cosine, -force * shape * sine]);
    }
}
