//! Motion of the bore under any jaws: the finite-element ring, condensed to one number per harmonic.
//!
//! The mesh is the same after a turn by one cell, so that a radial load of cos mθ newtons per radian on the
//! outside moves the bore by cₘ·cos mθ, up to the error of the mesh. Each cₘ is the solution of the whole
//! mesh and comes from a single cell ([`WaveRing`]); they are found until the bore no longer feels them, for
//! it is shielded from waves shorter than the wall. A jaw of force F at φ that presses over the arc w has
//!
//! ```text
//!   q(θ) = F/2π · [1 + 2 Σ sinc(mw/2) cos m(θ − φ)],  u_r(θ) = F/2π · [c₀ + 2 Σ cₘ sinc(mw/2) cos m(θ − φ)]
//! ```
//!
//! and jaws add. Arcs, angles and forces then cost a sum, and no solution. In plane stress u_r is
//! proportional to F/(E·b) and depends on the radii by their ratio alone; the ring that is solved has Ro = E
//! = b = 1. The first harmonic of loads in equilibrium is zero.

use std::f64::consts::TAU;
use std::fmt::Display;

use super::grip::Grip;
use super::jaws::Jaw;
use crate::element::plane::{Elasticity, PlaneElement, PlaneState, Quad4, Quad8};
use crate::mesh::{Grading, Mesh, RingMesh};
use crate::process::Failure;
use crate::solve::ring::{Cell, WaveRing};

/// The bore no longer feels a harmonic below this part of the largest.
const SHIELDED: f64 = 1e-10;

/// Numbers of elements of the ring's mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshSize {
    /// Elements around.
    pub circumferential: usize,
    /// Elements across the wall.
    pub radial: usize,
    /// 1 for 4-node, 2 for 8-node quadrilaterals.
    pub order: usize,
}

/// A ring as far as its elastic response depends on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Proportions {
    /// Ri/Ro.
    pub ratio: f64,
    /// ν.
    pub poisson_ratio: f64,
    /// Its elements.
    pub mesh: MeshSize,
    /// Only multiples of this harmonic occur: the number of jaws where they are evenly spaced, else 1.
    pub step: usize,
}

/// Compliances of the bore of a ring with Ro = E = b = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    step: usize,
    /// c₀, then those of the multiples of `step` from 2 on (the first harmonic is zero).
    compliances: Vec<f64>,
}

/// The radial displacement of the bore as a Fourier series, m per newton of jaw force with E = b = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct BoreSeries {
    step: usize,
    /// Coefficients of cos and sin of 0, 1, 2 … times `step`.
    coefficients: Vec<(f64, f64)>,
}

/// A ring that cannot be computed.
pub fn unsolvable(error: impl Display) -> Failure {
    Failure {
        message: format!("the ring cannot be computed: {error}"),
        help: "check diameters, material and mesh".into(),
    }
}

impl MeshSize {
    fn element(self) -> &'static dyn PlaneElement {
        if self.order == 1 { &Quad4 } else { &Quad8 }
    }

    /// The mesh of a ring of these radii, m.
    ///
    /// # Errors
    /// The radii or the numbers of elements make no mesh.
    pub fn mesh(self, outer_radius: f64, inner_radius: f64) -> Result<Mesh, Failure> {
        let Self { circumferential, radial, .. } = self;
        let (element, grading) = (self.element(), Grading::uniform());
        let ring = RingMesh { outer_radius, inner_radius, circumferential, radial, element, grading };
        ring.build().map_err(unsolvable)
    }
}

/// A wall that is too thin for sums of doubles.
fn stiffless() -> Failure {
    unsolvable("rounding leaves so thin a wall no stiffness")
}

impl Proportions {
    /// One cell of the ring with Ro = E = b = 1.
    fn cell(&self) -> Result<Cell, Failure> {
        let MeshSize { circumferential, radial, .. } = self.mesh;
        let law = Elasticity::new(PlaneState::Stress, 1.0, self.poisson_ratio, 0.0, 1.0).map_err(unsolvable)?;
        let (inner_radius, element) = (self.ratio, self.mesh.element());
        Ok(WaveRing { outer_radius: 1.0, inner_radius, circumferential, radial, element, law }.cell())
    }
}

impl Response {
    /// The response with these compliances: c₀, then those of the multiples of `step`.
    pub fn new(step: usize, compliances: Vec<f64>) -> Self {
        Self { step, compliances }
    }

    /// The response of a ring.
    ///
    /// # Errors
    /// Its equations cannot be solved.
    pub fn solve(ring: &Proportions) -> Result<Self, Failure> {
        let cell = ring.cell()?;
        let mut compliances: Vec<f64> = Vec::new();
        let mut largest = 0.0f64;
        // A wave over two cells is the shortest that the mesh can show.
        for m in (0..ring.mesh.circumferential.div_ceil(2)).step_by(ring.step) {
            let compliance = cell.compliance(m).ok_or_else(stiffless)?;
            compliances.push(compliance);
            largest = largest.max(compliance.abs());
            if m > 1 && compliance.abs() <= SHIELDED * largest {
                break;
            }
        }
        Ok(Self { step: ring.step, compliances })
    }

    /// How far the surface that evenly spaced jaws press on gives way at each of them, its mean over the arc of a jaw, per newton of
    /// jaw force with E = b = 1; the ring's step is their number.
    ///
    /// # Errors
    /// Its equations cannot be solved.
    pub fn yielding(ring: &Proportions, grip: Grip, arc: f64) -> Result<f64, Failure> {
        let cell = ring.cell()?;
        let mut sum = 0.0;
        for m in (0..ring.mesh.circumferential.div_ceil(2)).step_by(ring.step) {
            let own = cell.own_compliance(m, grip == Grip::Outside).ok_or_else(stiffless)?;
            let spread = sinc(0.5 * m as f64 * arc);
            sum += if m == 0 { 1.0 } else { 2.0 } * own * spread * spread;
        }
        Ok(ring.step as f64 / TAU * sum)
    }

    /// The bore under `jaws`.
    pub fn under(&self, jaws: &[Jaw]) -> BoreSeries {
        let coefficient = |(k, compliance): (usize, &f64)| {
            let m = (k * self.step) as f64;
            let twice = if k == 0 { 1.0 } else { 2.0 };
            let (mut cosine, mut sine) = (0.0, 0.0);
            for jaw in jaws {
                let spread = jaw.share * sinc(0.5 * m * jaw.arc);
                cosine += spread * (m * jaw.angle).cos();
                sine += spread * (m * jaw.angle).sin();
            }
            let factor = twice * compliance / TAU;
            (factor * cosine, factor * sine)
        };
        BoreSeries { step: self.step, coefficients: self.compliances.iter().enumerate().map(coefficient).collect() }
    }
}

impl BoreSeries {
    /// The series of what goes as sin m(θ − φ) where this one goes as cos m(θ − φ).
    pub fn beside(self) -> Self {
        Self { coefficients: self.coefficients.into_iter().map(|(a, b)| (-b, a)).collect(), ..self }
    }

    /// u_r at an angle (rad), positive outwards.
    pub fn radial(&self, angle: f64) -> f64 {
        // cos and sin of multiples by turning the one before.
        let (sine, cosine) = (self.step as f64 * angle).sin_cos();
        let (mut c, mut s, mut sum) = (1.0, 0.0, 0.0);
        for (a, b) in &self.coefficients {
            sum += a * c + b * s;
            (c, s) = (c * cosine - s * sine, s * cosine + c * sine);
        }
        sum
    }
}

/// sin x / x.
fn sinc(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.sin() / x }
}
