//! The half section of a stepped body of revolution: x runs along its axis, y is the radius.
//!
//! ```text
//!   y            +-- outside --+
//!   |            |             |     walls one after another from x = 0 on; a shoulder belongs to the
//!   +-- outside -+             |     outside or to the bore, whichever it borders
//!  left                      right
//!   +----- bore --------+      |
//!                       +- axis+
//!   --------------------------------> x
//! ```

use super::lattice::{Cell, Direction};
use super::ring::half_step;
use super::spacing::Stretches;
use super::{BORE, Lattice, Mesh, MeshError, OUTSIDE};
use crate::element::plane::PlaneElement;

/// Name of the end face at x = 0.
pub const LEFT: &str = "left";
/// Name of the other end face.
pub const RIGHT: &str = "right";
/// Name of what lies on the axis of a solid wall.
const AXIS: &str = "axis";

/// Least number of cells across each wall, and along the body.
const LEAST: usize = 4;
/// Part of the size of cells that a section stands off from another border of cells; a nearer one makes none, so that no
/// cell is a sliver.
const APART: f64 = 1e-3;
/// Difference of radii over the largest below which they are one.
const SAME: f64 = 1e-9;

/// A uniform length of the body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wall {
    /// Along the axis, m.
    pub length: f64,
    /// Inner and outer radius, m; 0 inside of a solid one.
    pub radii: [f64; 2],
}

/// The half section of a stepped body.
#[derive(Clone, Debug)]
pub struct RevolvedMesh {
    /// The walls, from x = 0 on.
    pub walls: Vec<Wall>,
    /// Longest side of a cell, m.
    pub size: f64,
    /// Places x (m) that are borders of cells.
    pub sections: Vec<f64>,
    /// The element.
    pub element: &'static dyn PlaneElement,
}

impl RevolvedMesh {
    /// Number of cells.
    pub fn cells(&self) -> f64 {
        let (along, across) = (self.along(), self.across());
        let between = |stretches: &Stretches, [low, high]: [f64; 2]| {
            let own = stretches.borders.windows(2).zip(&stretches.cells);
            own.filter(|(ends, _)| (low..high).contains(&(0.5 * (ends[0] + ends[1])))).map(|(_, n)| *n as f64).sum()
        };
        let mut start = 0.0;
        let own = self.walls.iter().map(|wall| {
            let ends = [start, start + wall.length];
            start = ends[1];
            let [columns, rows]: [f64; 2] = [between(&along, ends), between(&across, wall.radii)];
            columns * rows
        });
        own.sum()
    }

    /// Builds the mesh; its sides are `left`, `right`, `outside` and, where it is hollow or solid, `bore` and `axis`.
    ///
    /// # Errors
    /// Sizes out of range, walls that do not touch.
    pub fn build(&self) -> Result<Mesh, MeshError> {
        for Wall { length, radii: [inner, outer] } in self.walls.iter().copied() {
            for (holds, quantity, range, value) in [
                (length > 0.0 && length.is_finite(), "length of a wall (m)", "above zero".to_string(), length),
                (inner >= 0.0 && inner.is_finite(), "inner radius (m)", "zero or above".into(), inner),
                (outer > inner && outer.is_finite(), "outer radius (m)", format!("above {inner}"), outer),
            ] {
                if !holds {
                    return Err(MeshError::parameter(quantity, range, value));
                }
            }
        }
        if !(self.size > 0.0 && self.size.is_finite()) {
            return Err(MeshError::parameter("size of cells (m)", "above zero", self.size));
        }
        let (x, y) = (self.along().lines(), self.across().lines());
        let (columns, rows) = (x.len() - 1, y.len() - 1);
        let wall_of = |column: usize| {
            let middle = 0.5 * (x[column] + x[column + 1]);
            let mut end = 0.0;
            let ends_before = |wall: &&Wall| {
                end += wall.length;
                end <= middle
            };
            self.walls.iter().take_while(ends_before).count().min(self.walls.len() - 1)
        };
        let walls: Vec<usize> = (0..columns).map(wall_of).collect();
        let radius = |row: usize| 0.5 * (y[row] + y[row + 1]);
        let is_filled = |[column, row]: Cell| {
            let [inner, outer] = self.walls[walls[column]].radii;
            (inner..outer).contains(&radius(row))
        };
        let name = |[column, row]: Cell, direction: Direction| match direction {
            Direction::Top => OUTSIDE,
            Direction::Bottom if y[row] > 0.0 => BORE,
            Direction::Bottom => AXIS,
            Direction::Left if column == 0 => LEFT,
            Direction::Right if column + 1 == columns => RIGHT,
            Direction::Left | Direction::Right => {
                let beside = if direction == Direction::Left { column - 1 } else { column + 1 };
                if radius(row) < self.walls[walls[beside]].radii[0] { BORE } else { OUTSIDE }
            }
        };
        let lattice = Lattice { columns, rows, closed: false, element: self.element };
        let mesh = lattice.filled(is_filled, name, |i, j| [half_step(&x, i), half_step(&y, j)])?;
        mesh.connected()?;
        Ok(mesh)
    }

    /// Stretches along x: those of the walls, parted at the sections.
    fn along(&self) -> Stretches {
        let mut borders = vec![0.0];
        for wall in &self.walls {
            borders.push(borders[borders.len() - 1] + wall.length);
        }
        let [from, to] = [0.0, borders[borders.len() - 1]];
        let mut sections: Vec<f64> = self.sections.iter().copied().filter(|x| (from..to).contains(x)).collect();
        sections.sort_by(f64::total_cmp);
        for x in sections {
            if borders.iter().all(|border| (border - x).abs() > APART * self.size) {
                borders.push(x);
            }
        }
        borders.sort_by(f64::total_cmp);
        let mut stretches = Stretches::new(borders, self.size);
        stretches.refine([from, to], LEAST);
        stretches
    }

    /// Stretches along y: between all radii that there are.
    fn across(&self) -> Stretches {
        let mut radii: Vec<f64> = self.walls.iter().flat_map(|wall| wall.radii).collect();
        radii.sort_by(f64::total_cmp);
        let largest = radii.last().copied().unwrap_or(0.0);
        radii.dedup_by(|b, a| *b - *a <= SAME * largest);
        let mut stretches = Stretches::new(radii, self.size);
        self.walls.iter().for_each(|wall| stretches.refine(wall.radii, LEAST));
        stretches
    }
}
