//! The structured rectangle.
//!
//! ```text
//!   y
//!   +------ top ------+
//!  left             right      columns × rows cells
//!   +---- bottom -----+ x
//! ```

use super::ring::half_step;
use super::{Grading, Lattice, Mesh, MeshError};
use crate::element::plane::PlaneElement;

/// A rectangle with a corner at the origin.
#[derive(Clone, Debug)]
pub struct RectangleMesh {
    /// Length along x, m.
    pub length: f64,
    /// Height along y, m.
    pub height: f64,
    /// Cells along x.
    pub columns: usize,
    /// Cells along y.
    pub rows: usize,
    /// The element.
    pub element: &'static dyn PlaneElement,
    /// Places x (m) near which cells are shorter.
    pub along: Grading,
    /// Places y (m) near which cells are lower.
    pub across: Grading,
}

impl RectangleMesh {
    /// A rectangle of equal cells.
    pub fn uniform(
        [length, height]: [f64; 2],
        [columns, rows]: [usize; 2],
        element: &'static dyn PlaneElement,
    ) -> Self {
        Self { length, height, columns, rows, element, along: Grading::uniform(), across: Grading::uniform() }
    }

    /// Builds the mesh; its sides are `bottom`, `right`, `top` and `left`.
    ///
    /// # Errors
    /// Sizes or numbers of cells out of range.
    pub fn build(&self) -> Result<Mesh, MeshError> {
        for (size, quantity) in [(self.length, "length (m)"), (self.height, "height (m)")] {
            if !(size > 0.0 && size.is_finite()) {
                return Err(MeshError::parameter(quantity, "above zero", size));
            }
        }
        let x = self.along.line(0.0, self.length, self.columns)?;
        let y = self.across.line(0.0, self.height, self.rows)?;
        let lattice = Lattice { columns: self.columns, rows: self.rows, closed: false, element: self.element };
        lattice.mesh(["bottom", "right", "top", "left"], |i, j| [half_step(&x, i), half_step(&y, j)])
    }
}
