//! A body of pieces of different height on one flat underside, from end to end.
//!
//! ```text
//!   y    +-top-+       +-top-+
//!        |     +--top--+     |     cells as even as their borders allow, which stand at every
//!        +-----underside-----+ x   end of a piece and at every height
//! ```

use super::lattice::{Cell, Direction};
use super::ring::half_step;
use super::spacing::Stretches;
use super::{Lattice, Mesh, MeshError};
use crate::element::plane::PlaneElement;

/// Heights that differ by less than this part are one.
const SAME: f64 = 1e-9;

/// Pieces beside each other, a corner at the origin.
#[derive(Clone, Debug)]
pub struct SteppedMesh<'a> {
    /// Length and height of each piece from end to end, m.
    pub pieces: &'a [(f64, f64)],
    /// Longest side of a cell, m.
    pub size: f64,
    /// The element.
    pub element: &'static dyn PlaneElement,
}

impl SteppedMesh<'_> {
    /// Number of cells of the mesh, at least: the area over that of a cell.
    pub fn cells(&self) -> f64 {
        self.pieces.iter().map(|(length, height)| length * height).sum::<f64>() / (self.size * self.size)
    }

    /// Builds the mesh; its sides are `underside`, `top` and `ends`.
    ///
    /// # Errors
    /// Sizes out of range.
    pub fn build(&self) -> Result<Mesh, MeshError> {
        let sizes = self.pieces.iter().flat_map(|(length, height)| [(*length, "length (m)"), (*height, "height (m)")]);
        for (size, quantity) in sizes.chain([(self.size, "size of cells (m)")]) {
            if !(size > 0.0 && size.is_finite()) {
                return Err(MeshError::parameter(quantity, "above zero", size));
            }
        }
        let mut heights: Vec<f64> = self.pieces.iter().map(|own| own.1).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup_by(|b, a| *b - *a <= SAME * *b);
        let levels: Vec<f64> = [0.0].into_iter().chain(heights).collect();
        let y = Stretches::new(levels, self.size).lines();
        let mut ends = vec![0.0];
        self.pieces.iter().for_each(|(length, _)| ends.push(ends[ends.len() - 1] + length));
        let x = Stretches::new(ends.clone(), self.size).lines();
        // A cell belongs to the piece around its middle.
        let middle = |borders: &[f64], i: usize| 0.5 * (borders[i] + borders[i + 1]);
        let height = |column: usize| {
            self.pieces[ends[1..].partition_point(|to| *to < middle(&x, column)).min(self.pieces.len() - 1)].1
        };
        let lattice = Lattice { columns: x.len() - 1, rows: y.len() - 1, closed: false, element: self.element };
        let name = |_, direction| match direction {
            Direction::Bottom => "underside",
            Direction::Top => "top",
            Direction::Left | Direction::Right => "ends",
        };
        let is_filled = |[column, row]: Cell| middle(&y, row) < height(column);
        lattice.filled(is_filled, name, |i, j| [half_step(&x, i), half_step(&y, j)])
    }
}
