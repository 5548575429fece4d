//! Bodies at their true place and size, added to the grid of what was computed.

use crate::process::{Cell, Field, Frame, Grid};
use crate::units::{LENGTH, NUMBER};

/// The grid of a frame with the bodies that its own cells do not show, behind its own points and cells; every
/// point moves with the one it hangs on and has its values. `displacement_magnified` is the displacement so many
/// times; `body` numbers the bodies of the cells from 1, and is 0 for what was computed.
pub fn dressed(frame: &Frame, magnification: f64) -> Grid {
    let mut grid = frame.grid.clone();
    let mut sources: Vec<Option<u32>> = Vec::new();
    let mut numbers = vec![0.0; grid.cells.len()];
    for (number, body) in (1..).zip(&frame.bodies).filter(|(_, body)| !body.is_computed) {
        let first = grid.points.len() as u32;
        for point in &body.skin.points {
            let at = point.node.map_or([0.0; 3], |node| frame.grid.points[node as usize]);
            grid.points.push([0, 1, 2].map(|c| at[c] + point.offset[c]));
            sources.push(point.node);
        }
        for face in &body.skin.triangles {
            grid.push(Cell::Triangle, &face.map(|p| p + first));
        }
        for face in &body.skin.quads {
            grid.push(Cell::Quad, &face.map(|p| p + first));
        }
        numbers.resize(grid.cells.len(), f64::from(number));
    }
    for (field, own) in grid.point_fields.iter_mut().zip(&frame.grid.point_fields) {
        for source in &sources {
            match source {
                // A force acts at its point alone, and glyphs draw it once.
                _ if field.name == "force" => field.values.extend([0.0; 3]),
                Some(node) => field.values.extend_from_slice(own.at(*node as usize)),
                // What stands still has the values of the first point: a temperature of 0 K would be none.
                None if field.components == 1 => field.values.push(own.values.first().copied().unwrap_or(0.0)),
                None => field.values.extend(vec![0.0; field.components]),
            }
        }
    }
    if let Some(field) = grid.point_field("displacement") {
        let values = field.values.iter().map(|c| magnification * c).collect();
        grid.point_fields.push(Field { name: "displacement_magnified".into(), components: 3, kind: LENGTH, values });
    }
    grid.cell_fields.push(Field::scalar("body", NUMBER, numbers));
    grid
}
