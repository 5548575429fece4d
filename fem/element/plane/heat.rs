//! Heat in a plane body of uniform thickness t, or in a body of revolution, 2πy in the place of t.
//!
//! ```text
//!   ∫ δT ρc Ṫ t dA + ∫ ∇δT · k ∇T t dA = ∫ δT q t dA + ∮ δT (q_n − h (T − T_a)) t dl
//! ```

use super::{Sampled, Square, Thickness};

/// The spread of the heat capacity over the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Capacity {
    /// ∫ ρc Nₐ N_b t dA: higher accuracy; may overshoot in the first steps after a jump.
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
    /// The body across its plane.
    pub thickness: Thickness,
}

impl Conduction {
    /// Conduction matrix of an element, W/K: K_ab = ∫ k ∇Nₐ·∇N_b t dA.
    pub fn conductance(&self, sampled: &Sampled, coordinates: &[[f64; 2]], square: &mut Square<1>) {
        let products = sampled.gradient_products(self.thickness, coordinates);
        let factor = self.conductivity * self.thickness.scale();
        for a in 0..coordinates.len() {
            for b in 0..coordinates.len() {
                square[a][b] = [[factor * (products.xx[a][b] + products.yy[a][b])]];
            }
        }
    }

    /// Capacity matrix of an element, J/K: C_ab = ∫ ρc Nₐ N_b t dA, or its lumped form.
    pub fn capacity(&self, kind: Capacity, sampled: &Sampled, coordinates: &[[f64; 2]], square: &mut Square<1>) {
        let products = sampled.shape_products(self.thickness, coordinates);
        let factor = self.heat_capacity * self.thickness.scale();
        let nodes = coordinates.len();
        let trace: f64 = (0..nodes).map(|a| products[a][a]).sum();
        let scale = sampled.extent(self.thickness, coordinates) / trace;
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
