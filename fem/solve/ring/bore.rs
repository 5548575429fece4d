//! The radial displacement of the bore at any angle, by the elements' own shape functions.

use std::f64::consts::{PI, TAU};
use std::sync::Arc as Shared;

use super::circle::{Arc, all_around};
use crate::element::plane::quadrature::LINE_5;
use crate::mesh::{BORE, Mesh, MeshError};

/// The bore of a meshed ring.
#[derive(Clone, Debug)]
pub struct Bore {
    arcs: Shared<[Arc]>,
}

/// The bore of a displaced ring.
#[derive(Clone, Debug)]
pub struct BoreShape {
    bore: Bore,
    /// Displacements of the nodes of the sides, (sides, 3).
    motion: Vec<[[f64; 2]; 3]>,
    /// Rigid shift (m) taken out.
    shift: [f64; 2],
}

impl Bore {
    /// The sides [`BORE`] of the mesh.
    ///
    /// # Errors
    /// The mesh has no such sides, or they do not close around the origin.
    pub fn new(mesh: &Mesh) -> Result<Self, MeshError> {
        Ok(Self { arcs: all_around(mesh, BORE)?.into() })
    }

    /// The bore after `displacements` of the nodes (m), without the rigid shift: radial loads in equilibrium
    /// bring no first harmonic about, so that what there is of it is where the body happened to be held.
    pub fn shape(&self, displacements: &[[f64; 2]]) -> BoreShape {
        let own = |arc: &Arc| {
            let mut motion = [[0.0; 2]; 3];
            for (motion, &node) in motion.iter_mut().zip(arc.nodes.as_slice()) {
                *motion = displacements[node as usize];
            }
            motion
        };
        let mut shape = BoreShape { bore: self.clone(), motion: self.arcs.iter().map(own).collect(), shift: [0.0; 2] };
        shape.shift = [shape.harmonic(1).0, shape.harmonic(1).1];
        shape
    }
}

impl BoreShape {
    /// Radial displacement u_r (m, positive outwards) at `angle` (rad).
    pub fn radial(&self, angle: f64) -> f64 {
        let arcs = &self.bore.arcs;
        let turned = angle.rem_euclid(TAU);
        // the side below the angle; before the first one it is the last
        let index = arcs.partition_point(|arc| arc.low().rem_euclid(TAU) <= turned);
        let index = index.checked_sub(1).unwrap_or(arcs.len() - 1);
        self.on_arc(index, arcs[index].beyond(turned))
    }

    fn on_arc(&self, index: usize, beyond: f64) -> f64 {
        let arc = &self.bore.arcs[index];
        let shapes = arc.shapes(arc.beyond_start(beyond));
        let [mut x, mut y] = [-self.shift[0], -self.shift[1]];
        for (shape, motion) in shapes.into_iter().zip(self.motion[index]) {
            x += shape * motion[0];
            y += shape * motion[1];
        }
        let (sine, cosine) = (arc.low() + beyond).sin_cos();
        x * cosine + y * sine
    }

    /// Mean of u_r around the bore, m.
    pub fn mean(&self) -> f64 {
        0.5 * self.harmonic(0).0
    }

    /// Coefficients (m) of cos kθ and sin kθ in u_r, k ≥ 0: (1/π) ∫ u_r (cos kθ, sin kθ) dθ.
    pub fn harmonic(&self, k: u32) -> (f64, f64) {
        let (mut cosines, mut sines) = (0.0, 0.0);
        for (index, arc) in self.bore.arcs.iter().enumerate() {
            let half = 0.5 * arc.span.abs();
            for (place, weight) in LINE_5 {
                let beyond = half * (1.0 + place);
                let (sine, cosine) = (f64::from(k) * (arc.low() + beyond)).sin_cos();
                let value = self.on_arc(index, beyond) * half * weight / PI;
                cosines += value * cosine;
                sines += value * sine;
            }
        }
        (cosines, sines)
    }
}
