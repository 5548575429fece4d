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

/// Column and row of a cell.
pub type Cell = [usize; 2];

/// A way out of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Towards smaller j.
    Bottom,
    /// Towards growing i.
    Right,
    /// Towards growing j.
    Top,
    /// Towards smaller i.
    Left,
}

impl Direction {
    const ALL: [Self; 4] = [Self::Bottom, Self::Right, Self::Top, Self::Left];
}

impl Lattice {
    /// The mesh with its node at half steps (i, j) at `place(i, j)` (m), which must keep the sense of
    /// turning. Its sides `names` = (bottom, right, top, left) lie at j = 0, i = 2 columns, j = 2 rows and i
    /// = 0.
    ///
    /// # Errors
    /// As [`Mesh::new`].
    pub fn mesh(&self, names: [&str; 4], place: impl Fn(usize, usize) -> [f64; 2]) -> Result<Mesh, MeshError> {
        self.filled(|_| true, |_, direction| names[direction as usize], place)
    }

    /// The same of the cells (column, row) that are filled; the free sides of a cell bear the name that `name(cell,
    /// direction)` gives them.
    ///
    /// # Errors
    /// As [`Mesh::new`].
    pub fn filled<'n>(
        &self,
        is_filled: impl Fn(Cell) -> bool,
        name: impl Fn(Cell, Direction) -> &'n str,
        place: impl Fn(usize, usize) -> [f64; 2],
    ) -> Result<Mesh, MeshError> {
        let corners = self.corner_sets();
        let mut numbers = vec![u32::MAX; self.width() * (2 * self.rows + 1)];
        let mut nodes = Vec::new();
        let (mut connectivity, mut sides) = (Vec::new(), BTreeMap::<String, Vec<Side>>::new());
        let cells = (0..self.columns).flat_map(|column| (0..self.rows).map(move |row| [column, row]));
        for cell in cells.filter(|cell| is_filled(*cell)) {
            let [column, row] = cell;
            let is_free = |direction: &Direction| !self.beside(cell, *direction).is_some_and(&is_filled);
            let free: Vec<Direction> = Direction::ALL.into_iter().filter(is_free).collect();
            for corner in &corners {
                let places: Vec<Place> = corner.iter().map(|[i, j]| [2 * column + i, 2 * row + j]).collect();
                let element = (connectivity.len() / self.element.nodes()) as u32;
                for (side, direction) in self.sides_toward(&places, cell, &free) {
                    sides.entry(name(cell, direction).to_owned()).or_default().push(Side { element, side });
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

    /// The cell beside another one, if the lattice goes on there.
    fn beside(&self, [column, row]: Cell, direction: Direction) -> Option<Cell> {
        let around = |column: usize| if self.closed { column % self.columns } else { column };
        let [column, row] = match direction {
            Direction::Bottom => [column, row.checked_sub(1)?],
            Direction::Right => [around(column + 1), row],
            Direction::Top => [column, row + 1],
            Direction::Left if self.closed => [around(column + self.columns - 1), row],
            Direction::Left => [column.checked_sub(1)?, row],
        };
        (column < self.columns && row < self.rows).then_some([column, row])
    }

    /// Sides of the element at `places` of a cell that lie toward some directions.
    fn sides_toward(&self, places: &[Place], [column, row]: Cell, directions: &[Direction]) -> Vec<(u8, Direction)> {
        let mut found = Vec::new();
        for (side, nodes) in (0..).zip(self.element.edges()) {
            let is_on = |direction: &&Direction| {
                let on = |[i, j]: Place| match direction {
                    Direction::Bottom => j == 2 * row,
                    Direction::Right => i == 2 * column + 2,
                    Direction::Top => j == 2 * row + 2,
                    Direction::Left => i == 2 * column,
                };
                nodes.iter().all(|&node| on(places[node]))
            };
            found.extend(directions.iter().filter(is_on).map(|direction| (side, *direction)));
        }
        found
    }
}
