//! Shape of a process in space: points, cells and the fields on them, at one time or tool position. Plain data, SI
//! units, no knowledge of any file format.

use crate::element::plane::PlaneElement;
use crate::mesh::Mesh;
use crate::units::Kind;

/// Shape of a cell. The discriminant is VTK's cell type number.
///
/// Nodes are numbered as in VTK: corners counter-clockwise, then mid-side nodes from side 0-1
/// on, then the centre.
/// ```text
///   3---6---2     2
///   |       |     | \
///   7   8   5     5   4
///   |       |     |     \
///   0---4---1     0--3---1
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Cell {
    /// A point, such as a support or the tool.
    Vertex = 1,
    /// Two nodes.
    Line = 3,
    /// Three corners.
    Triangle = 5,
    /// Four corners.
    Quad = 9,
    /// Two ends, then the middle.
    QuadraticLine = 21,
    /// Three corners, three mid-sides (T6).
    QuadraticTriangle = 22,
    /// Four corners, four mid-sides (Q8).
    QuadraticQuad = 23,
    /// Four corners, four mid-sides, centre (Q9).
    BiquadraticQuad = 28,
}

impl Cell {
    /// Every shape, for tests over the whole list.
    pub const ALL: [Self; 8] = [
        Self::Vertex,
        Self::Line,
        Self::Triangle,
        Self::Quad,
        Self::QuadraticLine,
        Self::QuadraticTriangle,
        Self::QuadraticQuad,
        Self::BiquadraticQuad,
    ];

    /// The shape of a plane element, whose nodes are in the same order.
    pub fn of(element: &dyn PlaneElement) -> Self {
        match (element.corners(), element.nodes()) {
            (3, 3) => Self::Triangle,
            (3, _) => Self::QuadraticTriangle,
            (_, 4) => Self::Quad,
            (_, 8) => Self::QuadraticQuad,
            _ => Self::BiquadraticQuad,
        }
    }

    /// Number of nodes.
    pub const fn nodes(self) -> usize {
        match self {
            Self::Vertex => 1,
            Self::Line => 2,
            Self::Triangle | Self::QuadraticLine => 3,
            Self::Quad => 4,
            Self::QuadraticTriangle => 6,
            Self::QuadraticQuad => 8,
            Self::BiquadraticQuad => 9,
        }
    }

    /// VTK's cell type number (vtkCellType.h).
    pub const fn vtk_id(self) -> u8 {
        self as u8
    }
}

/// Values on the points or on the cells of a [`Grid`].
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    /// Name shown to the user; unique among the point fields and among the cell fields.
    pub name: String,
    /// Values per point or cell: 1 a scalar, 3 a vector (x, y, z), 6 a symmetric tensor
    /// (xx, yy, zz, xy, yz, xz), 9 a tensor by rows.
    pub components: usize,
    /// Kind of the values, with the unit in which they are shown.
    pub kind: Kind,
    /// Values in SI units, `(points or cells, components)` by rows.
    pub values: Vec<f64>,
}

impl Field {
    /// One value per point or cell, in SI units.
    pub fn scalar(name: impl Into<String>, kind: Kind, values: Vec<f64>) -> Self {
        Self { name: name.into(), components: 1, kind, values }
    }

    /// One vector (x, y, z) per point or cell, in SI units.
    pub fn vector(name: impl Into<String>, kind: Kind, values: Vec<[f64; 3]>) -> Self {
        Self { name: name.into(), components: 3, kind, values: values.into_flattened() }
    }

    /// One symmetric tensor (xx, yy, zz, xy, yz, xz) per point or cell, in SI units.
    pub fn tensor(name: impl Into<String>, kind: Kind, values: Vec<[f64; 6]>) -> Self {
        Self { name: name.into(), components: 6, kind, values: values.into_flattened() }
    }

    /// The values of one point or cell.
    pub fn at(&self, row: usize) -> &[f64] {
        &self.values[row * self.components..(row + 1) * self.components]
    }
}

/// Points, the cells between them and the fields on both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Grid {
    /// Coordinates x, y, z of every point, m.
    pub points: Vec<[f64; 3]>,
    /// Point indices of all cells one after another, `cells[i].nodes()` for cell `i`.
    pub connectivity: Vec<u32>,
    /// Shape of every cell.
    pub cells: Vec<Cell>,
    /// Fields with one row per point.
    pub point_fields: Vec<Field>,
    /// Fields with one row per cell.
    pub cell_fields: Vec<Field>,
}

impl Grid {
    /// The elements of a plane mesh at z = 0.
    pub fn of(mesh: &Mesh) -> Self {
        let points = mesh.nodes().iter().map(|[x, y]| [*x, *y, 0.0]).collect();
        let mut grid = Self { points, ..Self::default() };
        mesh.elements().for_each(|element| grid.push(Cell::of(element.kind), element.nodes));
        grid
    }

    /// The field of a name on the points.
    pub fn point_field(&self, name: &str) -> Option<&Field> {
        self.point_fields.iter().find(|field| field.name == name)
    }

    /// Appends a cell through `nodes`, which are point indices, `cell.nodes()` of them.
    pub fn push(&mut self, cell: Cell, nodes: &[u32]) {
        self.cells.push(cell);
        self.connectivity.extend_from_slice(nodes);
    }
}
