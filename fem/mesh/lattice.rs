//! Structured meshes: a lattice of cells, each filled by one quadrilateral or two triangles.
//!
//! ```text
//!   top (j = 2 rows)
//!   +-----+-----+     half steps i = 0 … 2 columns, j = 0 … 2 rows:
//!   |  \  |  \  |     corners at even i and j, middles and centres at odd ones;
//!   +-----+-----+     triangles share the diagonal from (i, j + 2) to (i + 2, j)
//!   |  \  |  \  |
//!   +-----+-----+ right (i = 2 columns; none where the lattice is closed)
//!   bottom (j = 0)
//! ```

use std::collections::BTreeMap;

use super::{Block, Mesh, MeshError, Side};
use crate::element::plane::PlaneElement;

/// A lattice of cells of one kind of element.
#[derive(Clone, Copy, Debug)]
pub struct Lattice {
    /// Cells along i.
    pub columns: usize,
    /// Cells along j.
    pub rows: usize,
    /// Whether the last column meets the first.
    pub closed: bool,
    /// The element; triangles fill a cell in pairs.
    pub element: &'static dyn PlaneElement,
}

/// A place of the lattice in half steps.
type Place = [usize; 2];

impl Lattice {
    /// The mesh with its node at half steps (i, j) at `place(i, j)` (m), which must keep the sense of
    /// turning. Its sides `names` = (bottom, right, top, left) lie at j = 0, i = 2 columns, j = 2 rows and i
    /// = 0.
    ///
    /// # Errors
    /// As [`Mesh::new`].
    pub fn mesh(&self, names: [&str; 4], place: impl Fn(usize, usize) -> [f64; 2]) -> Result<Mesh, MeshError> {
        self.mesh_where(|_, _| true, names, place)
    }

    /// As [`mesh`](Self::mesh), of the cells (column, row) that are `filled` alone. Sides are called by the neighbour that their
    /// cell does not have.
    ///
    /// # Errors
    /// As [`Mesh::new`].
    pub fn mesh_where(
        &self,
        filled: impl Fn(usize, usize) -> bool,
        names: [&str; 4],
        place: impl Fn(usize, usize) -> [f64; 2],
    ) -> Result<Mesh, MeshError> {
        let corners = self.corner_sets();
        let mut numbers = vec![u32::MAX; self.width() * (2 * self.rows + 1)];
        let mut nodes = Vec::new();
        let (mut connectivity, mut sides) = (Vec::new(), BTreeMap::<String, Vec<Side>>::new());
        let cells = (0..self.columns).flat_map(|column| (0..self.rows).map(move |row| (column, row)));
        for (column, row) in cells.filter(|(column, row)| filled(*column, *row)) {
            let bare = self.bare(&filled, column, row);
            for corner in &corners {
                let places: Vec<Place> = corner.iter().map(|[i, j]| [2 * column + i, 2 * row + j]).collect();
                let element = (connectivity.len() / self.element.nodes()) as u32;
                for (side, border) in self.borders(corner).filter(|(_, border)| bare[*border]) {
                    let name = names[border];
                    sides.entry(name.to_owned()).or_default().push(Side { element, side });
                }
                for [i, j] in places {
                    let number = &mut numbers[(i % self.width()) * (2 * self.rows + 1) + j];
                    if *number == u32::MAX {
                        *number = nodes.len() as u32;
                        nodes.push(place(i % self.width(), j));
                    }
                    connectivity.push(*number);
                }
            }
        }
        Mesh::new(nodes, vec![Block::new(self.element, connectivity)], sides)
    }

    /// Half steps along i.
    fn width(&self) -> usize {
        2 * self.columns + usize::from(!self.closed)
    }

    /// Places of the nodes of the elements of one cell, in half steps from its lower left corner.
    fn corner_sets(&self) -> Vec<Vec<Place>> {
        let places = |map: fn(f64) -> f64| -> Vec<Place> {
            self.element.reference().iter().map(|node| node.map(|x| map(x).round() as usize)).collect()
        };
        if self.element.corners() == 4 {
            vec![places(|x| 1.0 + x)]
        } else {
            vec![places(|x| 2.0 * x), places(|x| 2.0 - 2.0 * x)]
        }
    }

    /// Whether a cell has no neighbour below, to the right, above and to the left.
    fn bare(&self, filled: &impl Fn(usize, usize) -> bool, column: usize, row: usize) -> [bool; 4] {
        let last = self.columns - 1;
        let [right, left] = match self.closed {
            true => [Some((column + 1) % self.columns), Some((column + last) % self.columns)],
            false => [(column < last).then_some(column + 1), column.checked_sub(1)],
        };
        [
            row == 0 || !filled(column, row - 1),
            right.is_none_or(|right| !filled(right, row)),
            row + 1 == self.rows || !filled(column, row + 1),
            left.is_none_or(|left| !filled(left, row)),
        ]
    }

    /// Sides of an element whose nodes are at `corner` in its cell that lie on a border of the cell: 0 below, then
    /// counter-clockwise.
    fn borders(&self, corner: &[Place]) -> impl Iterator<Item = (u8, usize)> {
        let on = |nodes: &[usize]| {
            let all = |axis: usize, at: usize| nodes.iter().all(|&node| corner[node][axis] == at);
            [all(1, 0), all(0, 2), all(1, 2), all(0, 0)].into_iter().position(|is_on| is_on)
        };
        (0..).zip(self.element.edges()).filter_map(move |(side, nodes)| on(nodes).map(|border| (side, border)))
    }
}
