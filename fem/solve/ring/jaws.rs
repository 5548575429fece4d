//! Jaws: forces on the outer circle, spread evenly over a contact arc.
//!
//! ```text
//!   fₐ = −∫ (F/w) Nₐ(s(θ)) (cos θ, sin θ)ᵀ dθ  over the arc of full angle w about φ
//!   fₐ = −F Nₐ(s(φ)) (cos φ, sin φ)ᵀ           for w = 0, a line load
//! ```
//!
//! s(θ) is the parameter of the side at the polar angle θ, so that every part of the load acts through the centre and
//! the sum of the forces is exact, wherever the arc begins and ends within the sides.

use std::f64::consts::TAU;

use super::circle::{Arc, arcs};
use crate::element::plane::quadrature::LINE_5;
use crate::mesh::{Mesh, MeshError, OUTSIDE};
use crate::solve::elastic::Loads;

/// What one jaw does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactArc {
    /// Angle of its middle φ, rad.
    pub angle: f64,
    /// Full angle w over which it presses, rad; 0 for a line load.
    pub width: f64,
    /// Radial force F = ∫ p dA, N, positive inwards.
    pub force: f64,
}

/// Adds the forces of the jaws on the sides [`OUTSIDE`].
///
/// # Errors
/// The mesh has no such sides, or they do not close around the origin; a width outside [0, 2π].
pub fn add_jaws(loads: &mut Loads, mesh: &Mesh, jaws: &[ContactArc]) -> Result<(), MeshError> {
    let arcs = arcs(mesh, OUTSIDE)?;
    for jaw in jaws {
        if !(jaw.width >= 0.0 && jaw.width <= TAU) {
            return Err(MeshError::Parameter {
                quantity: "contact arc (rad)",
                range: "0 to 2π".to_owned(),
                value: jaw.width,
            });
        }
        if jaw.width == 0.0 {
            // the side below the angle by least, whatever rounding does at the ends
            if let Some(arc) = arcs.iter().min_by(|a, b| a.beyond(jaw.angle).total_cmp(&b.beyond(jaw.angle))) {
                push(loads, arc, arc.beyond(jaw.angle), jaw.force);
            }
            continue;
        }
        for arc in &arcs {
            press(loads, arc, jaw);
        }
    }
    Ok(())
}

/// Adds a radial force of `density`(θ) newtons per radian, positive inwards, all around the sides [`OUTSIDE`].
#[cfg(test)]
pub(super) fn add_radial(loads: &mut Loads, mesh: &Mesh, density: impl Fn(f64) -> f64) -> Result<(), MeshError> {
    for arc in &arcs(mesh, OUTSIDE)? {
        let half = 0.5 * arc.span.abs();
        for (place, weight) in LINE_5 {
            let beyond = half * (1.0 + place);
            push(loads, arc, beyond, density(arc.low() + beyond) * half * weight);
        }
    }
    Ok(())
}

/// Adds the part of a jaw's pressure that lies on one side.
fn press(loads: &mut Loads, arc: &Arc, jaw: &ContactArc) {
    let from = arc.beyond(jaw.angle - 0.5 * jaw.width);
    // the jaw may begin below the side and reach it after a turn
    for from in [from - TAU, from] {
        let (low, high) = (from.max(0.0), (from + jaw.width).min(arc.span.abs()));
        if high <= low {
            continue;
        }
        let half = 0.5 * (high - low);
        for (place, weight) in LINE_5 {
            push(loads, arc, low + half * (1.0 + place), jaw.force / jaw.width * half * weight);
        }
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
