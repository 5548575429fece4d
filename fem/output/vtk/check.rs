//! Checks a grid before it is written: VTK's readers fail on each of these problems, or show the grid
//! wrongly without a word.

use std::collections::HashSet;

use super::VtkError;
use crate::process::{Field, Grid};

/// Whether VTK can read `grid` and show it rightly.
pub(super) fn check(grid: &Grid) -> Result<(), VtkError> {
    mesh(grid)?;
    fields("point", &grid.point_fields, grid.points.len())?;
    fields("cell", &grid.cell_fields, grid.cells.len())
}

/// Checks points and cells: there are some, coordinates are finite, every cell's points exist.
fn mesh(grid: &Grid) -> Result<(), VtkError> {
    let (points, cells) = (grid.points.len(), grid.cells.len());
    if points == 0 || cells == 0 {
        return Err(VtkError::Empty { points, cells });
    }
    for (what, count) in [("points", points), ("cells", cells)] {
        if u32::try_from(count).is_err() {
            return Err(VtkError::TooLarge { what, count });
        }
    }
    if let Some(i) = not_finite(grid.points.as_flattened()) {
        return Err(VtkError::Coordinate { point: i / 3, value: grid.points.as_flattened()[i] });
    }
    let expected = grid.cells.iter().map(|c| c.nodes()).sum();
    let given = grid.connectivity.len();
    if given != expected {
        return Err(VtkError::Connectivity { cells, expected, given });
    }
    let mut nodes = grid.connectivity.iter();
    for (cell, &shape) in grid.cells.iter().enumerate() {
        if let Some(&point) = nodes.by_ref().take(shape.nodes()).find(|&&p| p as usize >= points) {
            return Err(VtkError::Node { cell, shape, point, points });
        }
    }
    Ok(())
}

/// Checks the fields of one `place` (`point` or `cell`) with `rows` points or cells: names,
/// components, lengths, values.
fn fields(place: &'static str, fields: &[Field], rows: usize) -> Result<(), VtkError> {
    let mut names = HashSet::with_capacity(fields.len());
    for field in fields {
        let name = || field.name.clone();
        if field.name.is_empty() || field.name.chars().any(char::is_control) {
            return Err(VtkError::FieldName { place, name: name() });
        }
        if !names.insert(field.name.as_str()) {
            return Err(VtkError::Duplicate { place, name: name() });
        }
        let components = field.components;
        if !matches!(components, 1 | 3 | 6 | 9) {
            return Err(VtkError::Components { place, name: name(), components });
        }
        let (expected, given) = (rows * components, field.values.len());
        if given != expected {
            return Err(VtkError::Length { place, name: name(), rows, components, expected, given });
        }
        if let Some(i) = not_finite(&field.values) {
            let (row, value) = (i / components, field.values[i]);
            return Err(VtkError::Value { place, name: name(), row, value });
        }
    }
    Ok(())
}

/// Index of the first NaN or infinite value.
fn not_finite(values: &[f64]) -> Option<usize> {
    values.iter().position(|v| !v.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::Cell;
    use crate::units::{FORCE, TEMPERATURE};

    /// A line and a vertex over two points, one scalar on the points and one vector on the cells.
    fn valid() -> Grid {
        let mut grid = Grid { points: vec![[0.0; 3], [1.0, 0.0, 0.0]], ..Grid::default() };
        grid.push(Cell::Line, &[0, 1]);
        grid.push(Cell::Vertex, &[1]);
        grid.point_fields.push(Field::scalar("temperature", TEMPERATURE, vec![293.15, 300.0]));
        grid.cell_fields.push(Field::vector("force", FORCE, vec![[0.0; 3], [1.0, -2.0, 3.0]]));
        grid
    }

    type Spoil = fn(&mut Grid);

    #[test]
    fn every_fault_is_named() {
        assert!(check(&valid()).is_ok());
        let faults: [(Spoil, &str); 13] = [
            (|g| g.points.clear(), "the grid has 0 points and 2 cells: VTK needs at least one of each"),
            (|g| g.cells.clear(), "the grid has 2 points and 0 cells: VTK needs at least one of each"),
            (|g| g.points[1][2] = f64::NAN, "point 1: coordinate NaN is not a finite number"),
            (|g| g.connectivity.truncate(2), "the connectivity has 2 entries, the 2 cells need 3"),
            (|g| g.connectivity[2] = 2, "cell 1 (Vertex) uses point 2, but there are 2 points"),
            (
                |g| g.point_fields[0].name.clear(),
                "point field \"\": a name must not be empty or hold control characters",
            ),
            (
                |g| g.cell_fields[0].name = "a\nb".into(),
                "cell field \"a\\nb\": a name must not be empty or hold control characters",
            ),
            (|g| g.point_fields.push(g.point_fields[0].clone()), "point field 'temperature' occurs twice"),
            (|g| g.cell_fields[0].components = 2, "cell field 'force' has 2 components: use 1, 3, 6 or 9"),
            (
                |g| g.point_fields[0].values.truncate(1),
                "point field 'temperature' has 1 values, 2 points x 1 components need 2",
            ),
            (|g| g.cell_fields[0].values.push(0.0), "cell field 'force' has 7 values, 2 cells x 3 components need 6"),
            (
                |g| g.point_fields[0].values[1] = f64::INFINITY,
                "point field 'temperature', point 1: inf is not a finite number",
            ),
            (|g| g.cell_fields[0].values[5] = f64::NAN, "cell field 'force', cell 1: NaN is not a finite number"),
        ];
        for (spoil, message) in faults {
            let mut grid = valid();
            spoil(&mut grid);
            assert_eq!(check(&grid).map_err(|e| e.to_string()), Err(message.to_owned()));
        }
    }
}
