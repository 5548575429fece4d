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
        let corners = self.corner_sets();
        let mut numbers = vec![u32::MAX; self.width() * (2 * self.rows + 1)];
        let mut nodes = Vec::new();
        let (mut connectivity, mut sides) = (Vec::new(), BTreeMap::<String, Vec<Side>>::new());
        for (column, row) in (0..self.columns).flat_map(|column| (0..self.rows).map(move |row| (column, row))) {
            for corner in &corners {
                let places: Vec<Place> = corner.iter().map(|[i, j]| [2 * column + i, 2 * row + j]).collect();
                let element = (connectivity.len() / self.element.nodes()) as u32;
                for (side, name) in self.named_sides(&places, names) {
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

    /// Sides of the element at `places` that lie on the border of the lattice.
    fn named_sides<'n>(&self, places: &[Place], names: [&'n str; 4]) -> Vec<(u8, &'n str)> {
        let [bottom, right, top, left] = names;
        let (last_column, last_row) = (2 * self.columns, 2 * self.rows);
        let mut found = Vec::new();
        for (side, nodes) in (0..).zip(self.element.edges()) {
            let all = |on: &dyn Fn(Place) -> bool| nodes.iter().all(|&node| on(places[node]));
            let borders: [(&dyn Fn(Place) -> bool, &str); 4] = [
                (&|[_, j]| j == 0, bottom),
                (&|[i, _]| i == last_column && !self.closed, right),
                (&|[_, j]| j == last_row, top),
                (&|[i, _]| i == 0 && !self.closed, left),
            ];
            found.extend(borders.iter().filter(|(on, _)| all(on)).map(|&(_, name)| (side, name)));
        }
        found
    }
}
