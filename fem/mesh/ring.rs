//! The structured ring.
//!
//! ```text
//!          outside
//!       .--+--+--.         cells around × cells across; middles of sides lie on their circles,
//!     +   .----.   +       at the middle angle
//!     |  |      |  |
//!     +   `----'   + θ = 0
//!       `--+--+--'
//!           bore
//! ```

use super::{Grading, Lattice, Mesh, MeshError};
use crate::element::plane::PlaneElement;

/// Name of the sides on the outer circle.
pub const OUTSIDE: &str = "outside";
/// Name of the sides on the inner circle.
pub const BORE: &str = "bore";

/// A ring about the origin.
#[derive(Clone, Debug)]
pub struct RingMesh {
    /// Outer radius, m.
    pub outer_radius: f64,
    /// Inner radius, m.
    pub inner_radius: f64,
    /// Cells around.
    pub circumferential: usize,
    /// Cells across.
    pub radial: usize,
    /// The element.
    pub element: &'static dyn PlaneElement,
    /// Angles (rad) near which cells are smaller.
    pub grading: Grading,
}

impl RingMesh {
    /// Builds the mesh; its sides are [`OUTSIDE`] and [`BORE`].
    ///
    /// # Errors
    /// Radii or numbers of cells out of range.
    pub fn build(&self) -> Result<Mesh, MeshError> {
        let Self { outer_radius, inner_radius, circumferential, radial, element, .. } = *self;
        if !(inner_radius > 0.0 && inner_radius.is_finite()) {
            return Err(MeshError::parameter("inner radius (m)", "above zero", inner_radius));
        }
        if !(outer_radius > inner_radius && outer_radius.is_finite()) {
            return Err(MeshError::parameter("outer radius (m)", format!("above {inner_radius}"), outer_radius));
        }
        if circumferential < 4 {
            return Err(MeshError::parameter("cells around the ring", "at least 4", circumferential as f64));
        }
        if radial < 1 {
            return Err(MeshError::parameter("cells across the ring", "at least 1", radial as f64));
        }
        let borders = self.grading.circle(circumferential)?;
        let lattice = Lattice { columns: circumferential, rows: radial, closed: true, element };
        // angle and inward depth turn the same way as x and y
        lattice.mesh([OUTSIDE, "", BORE, ""], |i, j| {
            let angle = half_step(&borders, i);
            let depth = j as f64 / (2 * radial) as f64;
            let radius = outer_radius * (1.0 - depth) + inner_radius * depth;
            [radius * angle.cos(), radius * angle.sin()]
        })
    }
}

/// The border or the middle of a cell at half step `i`.
pub(super) fn half_step(borders: &[f64], i: usize) -> f64 {
    0.5 * (borders[i / 2] + borders[i.div_ceil(2)])
}
