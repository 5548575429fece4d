//! Plane elasticity of an isotropic material.
//!
//! ```text
//!   δW = t ∫ δε : σ dA,   σ = D (ε − α ΔT (1, 1, 0)ᵀ),   ε = (u_x,x, u_y,y, u_x,y + u_y,x)ᵀ
//!
//!       | λ + 2μ   λ       0 |    μ = E / 2(1 + ν)
//!   D = | λ        λ + 2μ  0 |    λ = E ν / (1 − ν²)             plane stress
//!       | 0        0       μ |    λ = E ν / ((1 + ν)(1 − 2ν))    plane strain
//! ```

use super::{MAX_NODES, Sampled, Square};

/// Components of strain ε = (εxx, εyy, γxy) and of stress σ = (σxx, σyy, σxy).
pub const STRAINS: usize = 3;

/// The condition across the thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneState {
    /// σzz = 0: a plate, a ring free to widen.
    Stress,
    /// εzz = 0: a long body held at its ends.
    Strain,
}

/// The plane elastic law of a body of uniform thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elasticity {
    lambda: f64,
    mu: f64,
    /// Stress −σ per K of rise in a body held fast, Pa/K.
    thermal_stress: f64,
    thickness: f64,
}

/// A material or thickness that no body has.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{quantity} must be {range}, not {value}")]
pub struct ElasticityError {
    quantity: &'static str,
    range: &'static str,
    value: f64,
}

impl Elasticity {
    /// Young's modulus E (Pa), Poisson's ratio ν, thermal expansion α (1/K) and thickness t (m).
    ///
    /// # Errors
    /// E or t not above zero, ν outside (−1, 0.5), α not finite.
    pub fn new(
        state: PlaneState,
        youngs_modulus: f64,
        poisson_ratio: f64,
        expansion: f64,
        thickness: f64,
    ) -> Result<Self, ElasticityError> {
        let positive = |value: f64| value > 0.0 && value.is_finite();
        let checks = [
            (positive(youngs_modulus), "Young's modulus (Pa)", "above zero", youngs_modulus),
            (poisson_ratio > -1.0 && poisson_ratio < 0.5, "Poisson's ratio", "between -1 and 0.5", poisson_ratio),
            (expansion.is_finite(), "thermal expansion (1/K)", "finite", expansion),
            (positive(thickness), "thickness (m)", "above zero", thickness),
        ];
        for (holds, quantity, range, value) in checks {
            if !holds {
                return Err(ElasticityError { quantity, range, value });
            }
        }
        let (e, nu) = (youngs_modulus, poisson_ratio);
        let (lambda, thermal) = match state {
            PlaneState::Stress => (e * nu / (1.0 - nu * nu), e / (1.0 - nu)),
            PlaneState::Strain => (e * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), e / (1.0 - 2.0 * nu)),
        };
        Ok(Self { lambda, mu: e / (2.0 * (1.0 + nu)), thermal_stress: expansion * thermal, thickness })
    }

    /// Thickness t, m.
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// σ = D (ε − ε_th), Pa, at the strain ε and the rise of temperature ΔT (K).
    pub fn stress(&self, [x, y, shear]: [f64; STRAINS], rise: f64) -> [f64; STRAINS] {
        let mean = self.lambda * (x + y) - self.thermal_stress * rise;
        [mean + 2.0 * self.mu * x, mean + 2.0 * self.mu * y, self.mu * shear]
    }

    /// Elastic energy per volume ½ ε·Dε, J/m³, without thermal strain.
    pub fn energy_density(&self, strain: [f64; STRAINS]) -> f64 {
        let stress = self.stress(strain, 0.0);
        0.5 * strain.iter().zip(stress).map(|(strain, stress)| strain * stress).sum::<f64>()
    }

    /// Stiffness of an element, N/m: K_ab = t ∫ (λ ∇Nₐ⊗∇N_b + μ ∇N_b⊗∇Nₐ + μ ∇Nₐ·∇N_b I) dA, (nodes, nodes,
    /// 2, 2).
    pub fn stiffness(&self, sampled: &Sampled, coordinates: &[[f64; 2]], square: &mut Square<2>) {
        let products = sampled.gradient_products(coordinates);
        let (lambda, mu) = (self.lambda * self.thickness, self.mu * self.thickness);
        let nodes = coordinates.len();
        for a in 0..nodes {
            for b in 0..nodes {
                let (xx, yy) = (products.xx[a][b], products.yy[a][b]);
                let (xy, yx) = (products.xy[a][b], products.xy[b][a]);
                square[a][b] = [
                    [(lambda + 2.0 * mu) * xx + mu * yy, lambda * xy + mu * yx],
                    [lambda * yx + mu * xy, (lambda + 2.0 * mu) * yy + mu * xx],
                ];
            }
        }
    }

    /// Forces (N) on the nodes that are equivalent to a rise of temperature (K, at the nodes):
    /// fₐ = t ∫ D ε_th : ∇Nₐ dA, positive outwards for a warmer body.
    pub fn thermal_forces(
        &self,
        sampled: &Sampled,
        coordinates: &[[f64; 2]],
        rises: &[f64; MAX_NODES],
    ) -> [[f64; 2]; MAX_NODES] {
        let mut forces = [[0.0; 2]; MAX_NODES];
        sampled.integrate(coordinates, |da, shapes, along_x, along_y| {
            let rise: f64 = shapes.iter().zip(rises).map(|(shape, rise)| shape * rise).sum();
            let stress = self.thermal_stress * rise * self.thickness * da;
            for (a, force) in forces.iter_mut().enumerate() {
                *force = [force[0] + stress * along_x[a], force[1] + stress * along_y[a]];
            }
        });
        forces
    }

    /// Work (N m/K) of [`thermal_forces`](Self::thermal_forces) of a rise of 1 K at each node on a motion (m)
    /// of the nodes.
    pub fn thermal_work(
        &self,
        sampled: &Sampled,
        coordinates: &[[f64; 2]],
        motion: &[[f64; 2]; MAX_NODES],
    ) -> [f64; MAX_NODES] {
        let mut work = [0.0; MAX_NODES];
        sampled.integrate(coordinates, |da, shapes, along_x, along_y| {
            let growth: f64 = (0..MAX_NODES).map(|a| along_x[a] * motion[a][0] + along_y[a] * motion[a][1]).sum();
            let factor = self.thermal_stress * growth * self.thickness * da;
            work.iter_mut().zip(shapes).for_each(|(work, shape)| *work += factor * shape);
        });
        work
    }

    /// Strain at the reference point `at` of an element whose nodes move by `displacements` (m).
    pub fn strain_at(
        sampled: &Sampled,
        coordinates: &[[f64; 2]],
        displacements: &[[f64; 2]],
        at: [f64; 2],
    ) -> [f64; STRAINS] {
        let (along_x, along_y) = sampled.gradients_at(coordinates, at);
        let mut strain = [0.0; STRAINS];
        for (a, [ux, uy]) in displacements.iter().enumerate() {
            strain[0] += along_x[a] * ux;
            strain[1] += along_y[a] * uy;
            strain[2] += along_y[a] * ux + along_x[a] * uy;
        }
        strain
    }
}
