//! Stiffness of a body of revolution under waves around its axis.
//!
//! With x along the axis, y the radius and m waves around, the motion is
//!
//! ```text
//!   u = U·cos mθ,  v = V·cos mθ,  w = W·sin mθ        along the axis, outwards, around
//!   ε_x = U,x   ε_y = V,y   ε_θ = (V + m·W)/y
//!   γ_xy = U,y + V,x   γ_yθ = W,y − (W + m·V)/y   γ_xθ = W,x − m·U/y
//! ```
//!
//! (the first three as cos mθ, the last two as sin mθ): waves of one number hang together with no other, and each is a problem of the
//! half section alone. In m the stiffness is K₀ + m·K₁ + m²·K₂. Energies are per radian: of both squares the mean around falls out
//! against that of the loads [Zienkiewicz & Taylor, The Finite Element Method, semi-analytical processes].

use super::{Elasticity, MAX_NODES, Sampled, Square};

/// Strains: along, outwards, around, and the shears between them.
const ALL: usize = 6;

impl Elasticity {
    /// Factor (N/m per radian) of a power of m in the stiffness of an element of a half section, whose nodes stand at
    /// `coordinates` (m); of components along, outwards and around.
    pub fn wave_stiffness(&self, power: usize, sampled: &Sampled, coordinates: &[[f64; 2]], square: &mut Square<3>) {
        let nodes = coordinates.len();
        square.iter_mut().flatten().flatten().flatten().for_each(|entry| *entry = 0.0);
        sampled.integrate(coordinates, |da, shapes, along_x, along_y| {
            let y: f64 = shapes.iter().zip(coordinates).map(|(shape, node)| shape * node[1]).sum();
            // Strains by a motion of each component of a node: those that no wave changes, and those that grow with m.
            let strains = |a: usize| {
                let (x, y, hoop) = (along_x[a], along_y[a], shapes[a] / y);
                let still =
                    [[x, 0.0, 0.0, y, 0.0, 0.0], [0.0, y, hoop, x, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0, y - hoop, x]];
                let waved = [
                    [0.0, 0.0, 0.0, 0.0, 0.0, -hoop],
                    [0.0, 0.0, 0.0, 0.0, -hoop, 0.0],
                    [0.0, 0.0, hoop, 0.0, 0.0, 0.0],
                ];
                [still, waved]
            };
            let mut all = [[[[0.0; ALL]; 3]; 2]; MAX_NODES];
            all.iter_mut().take(nodes).enumerate().for_each(|(a, own)| *own = strains(a));
            for a in 0..nodes {
                for b in 0..nodes {
                    for of_a in 0..2usize {
                        let Some(of_b) = power.checked_sub(of_a).filter(|of_b| *of_b < 2) else { continue };
                        for i in 0..3 {
                            for j in 0..3 {
                                square[a][b][i][j] += da * y * self.product(&all[a][of_a][i], &all[b][of_b][j]);
                            }
                        }
                    }
                }
            }
        });
    }

    /// Work of the stress of one strain on another, Pa.
    fn product(&self, one: &[f64; ALL], other: &[f64; ALL]) -> f64 {
        let sum = |strain: &[f64; ALL]| strain[0] + strain[1] + strain[2];
        let stretched: f64 = (0..3).map(|k| one[k] * other[k]).sum();
        let sheared: f64 = (3..ALL).map(|k| one[k] * other[k]).sum();
        self.lambda * sum(one) * sum(other) + self.mu * (2.0 * stretched + sheared)
    }
}
