//! Elasticity of an isotropic material in a plane body of uniform thickness t, or in a body of revolution about the axis
//! x, 2πy in the place of t.
//!
//! ```text
//!   δW = ∫ δε : σ t dA,   σ = D (ε − α ΔT (1, 1, 0, 1)ᵀ),   ε = (u_x,x, u_y,y, u_x,y + u_y,x, ε_a)ᵀ
//!
//!       | λ + 2μ   λ       0  λ      |    μ = E / 2(1 + ν)
//!   D = | λ        λ + 2μ  0  λ      |    λ = E ν / ((1 + ν)(1 − 2ν))
//!       | 0        0       μ  0      |    ε_a = 0        plane strain
//!       | λ        λ       0  λ + 2μ |    ε_a = u_y / y  body of revolution: the strain of its circles
//! ```
//!
//! Of plane stress σ_a = 0 and λ = E ν / (1 − ν²) among the first three.

use super::{MAX_NODES, Sampled, Square, Thickness};

/// Components of strain ε = (εxx, εyy, γxy, ε_a) and of stress σ = (σxx, σyy, σxy, σ_a), a across the plane.
pub const STRAINS: usize = 4;

/// Radius over that of the element's farthest node below which a point of a body of revolution is on its axis.
const ON_AXIS: f64 = 1e-9;

/// The condition across the thickness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlaneState {
    /// σzz = 0: a plate, a ring free to widen.
    Stress,
    /// εzz = 0: a long body held at its ends.
    Strain,
}

/// The elastic law of a plane body of uniform thickness, or of a body of revolution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elasticity {
    pub(super) lambda: f64,
    pub(super) mu: f64,
    /// Stress −σ per K of rise in a body held fast, Pa/K.
    thermal_stress: f64,
    /// Whether the body is free to grow across its plane.
    is_free_across: bool,
    thickness: Thickness,
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
        Ok(Self {
            lambda,
            mu: e / (2.0 * (1.0 + nu)),
            thermal_stress: expansion * thermal,
            is_free_across: state == PlaneState::Stress,
            thickness: Thickness::Uniform(thickness),
        })
    }

    /// The law of a body of revolution about the axis x, y the radius.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn revolved(youngs_modulus: f64, poisson_ratio: f64, expansion: f64) -> Result<Self, ElasticityError> {
        // Across its half section a body of revolution is held by itself, as a plane strain is; its circles stretch.
        let held = Self::new(PlaneState::Strain, youngs_modulus, poisson_ratio, expansion, 1.0)?;
        Ok(Self { thickness: Thickness::Revolved, ..held })
    }

    /// The body across its plane.
    pub fn thickness(&self) -> Thickness {
        self.thickness
    }

    /// σ = D (ε − ε_th), Pa, at the strain ε and the rise of temperature ΔT (K). What is free to grow across its plane
    /// has whatever strain it takes there.
    pub fn stress(&self, [x, y, shear, across]: [f64; STRAINS], rise: f64) -> [f64; STRAINS] {
        let across = if self.is_free_across { 0.0 } else { across };
        let mean = self.lambda * (x + y + across) - self.thermal_stress * rise;
        let own = if self.is_free_across { 0.0 } else { mean + 2.0 * self.mu * across };
        [mean + 2.0 * self.mu * x, mean + 2.0 * self.mu * y, self.mu * shear, own]
    }

    /// Elastic energy per volume ½ ε·Dε, J/m³, without thermal strain.
    pub fn energy_density(&self, strain: [f64; STRAINS]) -> f64 {
        let stress = self.stress(strain, 0.0);
        0.5 * strain.iter().zip(stress).map(|(strain, stress)| strain * stress).sum::<f64>()
    }

    /// Stiffness of an element, N/m: K_ab = ∫ (λ ∇Nₐ⊗∇N_b + μ ∇N_b⊗∇Nₐ + μ ∇Nₐ·∇N_b I) t dA, (nodes, nodes,
    /// 2, 2), and what the circles of a body of revolution add.
    pub fn stiffness(&self, sampled: &Sampled, coordinates: &[[f64; 2]], square: &mut Square<2>) {
        let products = sampled.gradient_products(self.thickness, coordinates);
        let (lambda, mu) = (self.lambda * self.thickness.scale(), self.mu * self.thickness.scale());
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
        if self.thickness.is_revolved() {
            self.add_hoops(sampled, coordinates, square);
        }
    }

    /// Adds the energy of the hoop strain: with Hₐ = Nₐ/y of the radial component ∫ ((λ + 2μ) Hₐ H_b + λ (Hₐ ∇N_b +
    /// H_b ∇Nₐ)) 2πy dA.
    fn add_hoops(&self, sampled: &Sampled, coordinates: &[[f64; 2]], square: &mut Square<2>) {
        let hoop = sampled.hoop_products(coordinates);
        let (lambda, mu) = (self.lambda * self.thickness.scale(), self.mu * self.thickness.scale());
        for a in 0..coordinates.len() {
            for b in 0..coordinates.len() {
                let own = &mut square[a][b];
                own[1][1] += (lambda + 2.0 * mu) * hoop.hoops[a][b] + lambda * (hoop.y[a][b] + hoop.y[b][a]);
                own[1][0] += lambda * hoop.x[a][b];
                own[0][1] += lambda * hoop.x[b][a];
            }
        }
    }

    /// Forces (N) on the nodes that are equivalent to a rise of temperature (K, at the nodes):
    /// fₐ = ∫ D ε_th : ∇Nₐ t dA, positive outwards for a warmer body.
    pub fn thermal_forces(
        &self,
        sampled: &Sampled,
        coordinates: &[[f64; 2]],
        rises: &[f64; MAX_NODES],
    ) -> [[f64; 2]; MAX_NODES] {
        let mut forces = [[0.0; 2]; MAX_NODES];
        sampled.integrate_weighted(self.thickness, coordinates, |own, y, shapes, along_x, along_y| {
            let hoops = self.thickness.hoops(shapes, y);
            let rise: f64 = shapes.iter().zip(rises).map(|(shape, rise)| shape * rise).sum();
            let stress = self.thermal_stress * rise * self.thickness.scale() * own;
            for (a, force) in forces.iter_mut().enumerate() {
                *force = [force[0] + stress * along_x[a], force[1] + stress * (along_y[a] + hoops[a])];
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
        sampled.integrate_weighted(self.thickness, coordinates, |own, y, shapes, along_x, along_y| {
            let hoops = self.thickness.hoops(shapes, y);
            let part = |a: usize| along_x[a] * motion[a][0] + (along_y[a] + hoops[a]) * motion[a][1];
            let growth: f64 = (0..MAX_NODES).map(part).sum();
            let factor = self.thermal_stress * growth * self.thickness.scale() * own;
            work.iter_mut().zip(shapes).for_each(|(work, shape)| *work += factor * shape);
        });
        work
    }

    /// Strain at the reference point `at` of an element whose nodes move by `displacements` (m). On its axis a body of
    /// revolution stretches around as along the radius.
    pub fn strain_at(
        &self,
        sampled: &Sampled,
        coordinates: &[[f64; 2]],
        displacements: &[[f64; 2]],
        at: [f64; 2],
    ) -> [f64; STRAINS] {
        let (along_x, along_y) = sampled.gradients_at(coordinates, at);
        let shapes = sampled.element().shapes(at);
        let y = sampled.point_at(coordinates, at)[1];
        let size = coordinates.iter().fold(0.0_f64, |size, node| size.max(node[1].abs()));
        let is_on_axis = y <= ON_AXIS * size;
        let hoops = if is_on_axis { [0.0; MAX_NODES] } else { self.thickness.hoops(&shapes, y) };
        let mut strain = [0.0; STRAINS];
        for (a, [ux, uy]) in displacements.iter().enumerate() {
            strain[0] += along_x[a] * ux;
            strain[1] += along_y[a] * uy;
            strain[2] += along_y[a] * ux + along_x[a] * uy;
            strain[3] += hoops[a] * uy;
        }
        if is_on_axis && self.thickness.is_revolved() {
            strain[3] = strain[1];
        }
        strain
    }
}
