//! What the bore does under any jaws: the finite-element ring, condensed to one number per harmonic.
//!
//! The mesh is the same after a turn by one cell, so that a radial load of cos mθ newtons per radian on the outside moves the bore
//! by cₘ·cos mθ, up to the error of the mesh. Each cₘ is the solution of the whole mesh and comes from a single cell ([`WaveRing`]); they are found until the
//! bore no longer feels them, for it is shielded from waves shorter than the wall. A jaw of force F at φ that presses over the arc w has
//!
//! ```text
//!   q(θ) = F/2π · [1 + 2 Σ sinc(mw/2) cos m(θ − φ)],    u_r(θ) = F/2π · [c₀ + 2 Σ cₘ sinc(mw/2) cos m(θ − φ)]
//! ```
//!
//! and jaws add. Arcs, angles and forces then cost a sum, and no solution. In plane stress u_r is proportional to F/(E·b) and depends on the radii
//! by their ratio alone; the ring that is solved has Ro = E = b = 1. The first harmonic of loads in equilibrium is zero.

use std::sync::{Arc, Mutex, PoisonError};

use super::model::{MeshSize, Setup};
use crate::element::plane::{Elasticity, PlaneElement, PlaneState, Quad4, Quad8};
use crate::mesh::{Grading, Mesh, RingMesh};
use crate::process::Failure;
use crate::solve::ring::WaveRing;

/// The bore no longer feels a harmonic below this part of the largest.
const SHIELDED: f64 = 1e-10;
/// Rings kept: a search tries many values of all else for one ring.
const MOST_RINGS: usize = 16;

/// A ring as far as its elastic response depends on it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Shape {
    /// Ri/Ro.
    ratio: f64,
    poisson_ratio: f64,
    mesh: MeshSize,
    /// Only multiples of this harmonic occur: the number of jaws where they are evenly spaced, else 1.
    step: usize,
}

/// Compliances of the bore of a ring with Ro = E = b = 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    step: usize,
    /// c₀, then those of the multiples of `step` from 2 on (the first harmonic is zero).
    compliances: Vec<f64>,
}

/// The radial displacement of the bore as a Fourier series, m per newton of jaw force.
#[derive(Clone, Debug, PartialEq)]
pub struct BoreSeries {
    step: usize,
    /// Coefficients of cos and sin of 0, 1, 2 … times `step`.
    coefficients: Vec<(f64, f64)>,
}

/// A jaw: where it stands (rad), over which full angle it presses (rad), and its force over that of a jaw of an even chuck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jaw {
    /// rad.
    pub angle: f64,
    /// rad; 0 for a line load.
    pub arc: f64,
    /// Share, 1 where jaws are evenly spaced.
    pub share: f64,
}

static RECENT: Mutex<Vec<(Shape, Arc<Response>)>> = Mutex::new(Vec::new());

/// The response of the model's ring to jaws of which only multiples of the harmonic `step` occur, solved once for the same ring.
///
/// # Errors
/// The mesh cannot be built, or its equations not be solved.
pub fn response(setup: &Setup, mesh: MeshSize, step: usize) -> Result<Arc<Response>, Failure> {
    let shape = Shape {
        ratio: setup.inner_radius / setup.outer_radius,
        poisson_ratio: setup.material.poisson_ratio,
        mesh,
        step,
    };
    // A panic while the list was held leaves it whole: entries are added and removed in one step each.
    let recent = || RECENT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, known)) = recent().iter().find(|(s, _)| *s == shape) {
        return Ok(known.clone());
    }
    // Solved without the list, which others need meanwhile; two that solve the same do no harm.
    let solved = Arc::new(Response::solve(shape)?);
    let mut list = recent();
    if list.len() >= MOST_RINGS {
        list.remove(0);
    }
    list.push((shape, solved.clone()));
    Ok(solved)
}

fn element(order: usize) -> &'static dyn PlaneElement {
    if order == 1 { &Quad4 } else { &Quad8 }
}

/// The mesh of a ring.
///
/// # Errors
/// The radii or the numbers of elements make no mesh.
pub fn mesh(outer_radius: f64, inner_radius: f64, size: MeshSize) -> Result<Mesh, Failure> {
    let MeshSize { circumferential, radial, order } = size;
    let element = element(order);
    let grading = Grading::uniform();
    let ring = RingMesh { outer_radius, inner_radius, circumferential, radial, element, grading };
    ring.build().map_err(|error| unsolvable(&error))
}

/// A ring that cannot be computed.
pub fn unsolvable(error: &dyn std::fmt::Display) -> Failure {
    Failure {
        message: format!("the ring cannot be computed: {error}"),
        help: "check diameters, material and mesh".into(),
    }
}

impl Response {
    fn solve(shape: Shape) -> Result<Self, Failure> {
        let law = Elasticity::new(PlaneState::Stress, 1.0, shape.poisson_ratio, 0.0, 1.0);
        let MeshSize { circumferential, radial, order } = shape.mesh;
        let ring = WaveRing {
            outer_radius: 1.0,
            inner_radius: shape.ratio,
            circumferential,
            radial,
            element: element(order),
            law: law.map_err(|error| unsolvable(&error))?,
        };
        let cell = ring.cell();
        let lost = || unsolvable(&"rounding leaves so thin a wall no stiffness");
        let mut compliances: Vec<f64> = Vec::new();
        let mut largest = 0.0f64;
        // A wave over two cells is the shortest that the mesh can show.
        for m in (0..circumferential.div_ceil(2)).step_by(shape.step) {
            let compliance = cell.compliance(m).ok_or_else(lost)?;
            compliances.push(compliance);
            largest = largest.max(compliance.abs());
            if m > 1 && compliance.abs() <= SHIELDED * largest {
                break;
            }
        }
        Ok(Self { step: shape.step, compliances })
    }

    /// The bore of the model's ring under `jaws`.
    pub fn under(&self, setup: &Setup, jaws: &[Jaw]) -> BoreSeries {
        let scale = 1.0 / (std::f64::consts::TAU * setup.material.youngs_modulus * setup.width);
        let coefficient = |(k, compliance): (usize, &f64)| {
            let m = (k * self.step) as f64;
            let twice = if k == 0 { 1.0 } else { 2.0 };
            let (mut cosine, mut sine) = (0.0, 0.0);
            for jaw in jaws {
                let spread = jaw.share * sinc(0.5 * m * jaw.arc);
                cosine += spread * (m * jaw.angle).cos();
                sine += spread * (m * jaw.angle).sin();
            }
            let factor = scale * twice * compliance;
            (factor * cosine, factor * sine)
        };
        BoreSeries { step: self.step, coefficients: self.compliances.iter().enumerate().map(coefficient).collect() }
    }
}

impl BoreSeries {
    /// u_r per newton of jaw force at an angle (rad), m/N, positive outwards.
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
