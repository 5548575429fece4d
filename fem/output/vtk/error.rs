//! Errors of VTK output: every variant says where and what was given.

use thiserror::Error;

use crate::process::Cell;

/// Reason for which a grid or a list of frames cannot be written.
#[derive(Debug, Error)]
pub enum VtkError {
    /// VTK's readers refuse a file without points or cells.
    #[error("the grid has {points} points and {cells} cells: VTK needs at least one of each")]
    Empty {
        /// Number of points.
        points: usize,
        /// Number of cells.
        cells: usize,
    },
    /// vtkio counts points and cells in 32 bits.
    #[error("{count} {what} do not fit into a .vtu file (at most {})", u32::MAX)]
    TooLarge {
        /// `points` or `cells`.
        what: &'static str,
        /// Number of points or cells.
        count: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("point {point}: coordinate {value} is not a finite number")]
    Coordinate {
        /// Index of the point.
        point: usize,
        /// The value, m.
        value: f64,
    },
    /// The connectivity does not hold what the cells need.
    #[error("the connectivity has {given} entries, the {cells} cells need {expected}")]
    Connectivity {
        /// Number of cells.
        cells: usize,
        /// Sum of the cells' nodes.
        expected: usize,
        /// Entries given.
        given: usize,
    },
    /// A cell refers to a point that does not exist.
    #[error("cell {cell} ({shape:?}) uses point {point}, but there are {points} points")]
    Node {
        /// Index of the cell.
        cell: usize,
        /// Its shape.
        shape: Cell,
        /// The index given.
        point: u32,
        /// Number of points.
        points: usize,
    },
    /// A field's name is empty or holds a control character, which XML cannot carry.
    #[error("{place} field {name:?}: a name must not be empty or hold control characters")]
    FieldName {
        /// `point` or `cell`.
        place: &'static str,
        /// The name.
        name: String,
    },
    /// Two fields of the same place share a name; VTK would show only one of them.
    #[error("{place} field '{name}' occurs twice")]
    Duplicate {
        /// `point` or `cell`.
        place: &'static str,
        /// The name.
        name: String,
    },
    /// A field has a number of components that has no meaning in VTK.
    #[error("{place} field '{name}' has {components} components: use 1, 3, 6 or 9")]
    Components {
        /// `point` or `cell`.
        place: &'static str,
        /// The field.
        name: String,
        /// Components given.
        components: usize,
    },
    /// A field has too few or too many values.
    #[error("{place} field '{name}' has {given} values, {rows} {place}s x {components} components need {expected}")]
    Length {
        /// `point` or `cell`.
        place: &'static str,
        /// The field.
        name: String,
        /// Number of points or cells.
        rows: usize,
        /// Components per point or cell.
        components: usize,
        /// `rows` x `components`.
        expected: usize,
        /// Values given.
        given: usize,
    },
    /// A field holds NaN or an infinite value.
    #[error("{place} field '{name}', {place} {row}: {value} is not a finite number")]
    Value {
        /// `point` or `cell`.
        place: &'static str,
        /// The field.
        name: String,
        /// Index of the point or cell.
        row: usize,
        /// The value.
        value: f64,
    },
    /// The times of a `.pvd` are not finite, or do not increase.
    #[error("frame {frame} ('{file}'): time {time} must be finite and greater than the time before")]
    Time {
        /// Index of the frame.
        frame: usize,
        /// Its file name.
        file: String,
        /// Its time, s.
        time: f64,
    },
    /// A file name is empty or holds a control character, which XML cannot carry.
    #[error("frame {frame}: file name {file:?} must not be empty or hold control characters")]
    FileName {
        /// Index of the frame.
        frame: usize,
        /// Its file name.
        file: String,
    },
    /// vtkio could not serialise the grid.
    #[error("writing VTK XML failed")]
    Write(#[from] vtkio::xml::Error),
}
