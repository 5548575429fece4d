//! Heat in a plane body of uniform thickness.
//!
//! ```text
//!   t ∫ δT ρc Ṫ dA + t ∫ ∇δT · k ∇T dA = t ∫ δT q dA + t ∮ δT (q_n − h (T − T_a)) dl
//! ```

use super::{Sampled, Square};

/// The spread of the heat capacity over the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Capacity {
    /// t ∫ ρc Nₐ N_b dA: higher accuracy; may overshoot in the first steps after a jump.
    #[default]
    Consistent,
    /// The diagonal of that, scaled to the element's whole capacity (Hinton, Rock and Zienkiewicz 1976):
    /// positive for every element.
    Lumped,
}

/// The plane heat law of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conduction {
    /// Conductivity k, W/(m K).
    pub conductivity: f64,
    /// Heat capacity ρc, J/(m³ K).
    pub heat_capacity: f64,
    /// Thickness t, m.
    pub thickness: f64,
}

impl Conduction {
    /// Conduction matrix of an element, W/K: K_ab = t ∫ k ∇Nₐ·∇N_b dA.
    pub fn conductance(&self, sampled: &Sampled, coordinates: &[[f64; 2]], square: &mut Square<1>) {
        let products = sampled.gradient_products(coordinates);
        let factor = self.conductivity * self.thickness;
        for a in 0..coordinates.len() {
            for b in 0..coordinates.len() {
                square[a][b] = [[factor * (products.xx[a][b] + products.yy[a][b])]];
            }
        }
    }

    /// Capacity matrix of an element, J/K: C_ab = t ∫ ρc Nₐ N_b dA, or its lumped form.
    pub fn capacity(&self, kind: Capacity, sampled: &Sampled, coordinates: &[[f64; 2]], square: &mut Square<1>) {
        let products = sampled.shape_products(coordinates);
        let factor = self.heat_capacity * self.thickness;
        let nodes = coordinates.len();
        let trace: f64 = (0..nodes).map(|a| products[a][a]).sum();
        let scale = sampled.area(coordinates) / trace;
        for a in 0..nodes {
            for b in 0..nodes {
                let part = match kind {
                    Capacity::Consistent => products[a][b],
                    Capacity::Lumped if a == b => scale * products[a][a],
                    Capacity::Lumped => 0.0,
                };
                square[a][b] = [[factor * part]];
            }
        }
    }
}
