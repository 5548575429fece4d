//! VTK XML: of every [`Frame`](crate::process::Frame) a `.vtu` with true geometry and a `.vtp` with displacements
//! magnified, and the `.pvd` that lists each in time. ParaView opens a `.pvd` and plays it.
//!
//! Numbers of a `.vtu` are stored as 64-bit little-endian binary, so what a reader gets is bit for bit what
//! was computed. The first scalar and the first vector field become the active ones, so that
//! ParaView colours by the one and Warp By Vector finds the other.

mod bodies;
mod check;
mod error;
mod field_data;
mod picture;
mod pvd;
mod series;
mod survey;
mod view;

use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataArray, DataSet, ElementType, IOBuffer,
    UnstructuredGridPiece, Version, VertexNumbers, Vtk,
};
use vtkio::xml::Compressor;

use crate::process::{Cell, Field, Grid};
use crate::units::{ENERGY, FORCE, Kind, MOMENT, STRESS};

pub use error::VtkError;
pub use pvd::pvd;
pub use series::{Files, Series};

/// The bytes of one `.vtu` file: a whole unstructured grid with its fields, checked first.
///
/// # Errors
/// Empty grids, cells that refer to missing points, fields of wrong length, NaN or infinity:
/// VTK's readers fail on each of these or show them wrongly.
pub fn vtu(grid: &Grid) -> Result<Vec<u8>, VtkError> {
    check::check(grid)?;
    encode(vtk(grid))
}

/// The bytes of a file. Around a revolved body values repeat, and so do differences of connectivities: LZ4 makes files
/// several times smaller, and takes less time than writing the rest would.
fn encode(file: Vtk) -> Result<Vec<u8>, VtkError> {
    // LZ4 has one level; a level of 0 would leave the arrays as they are.
    let file = file.try_into_xml_format(Compressor::LZ4, 1)?;
    let mut bytes = Vec::new();
    file.write(&mut bytes)?;
    Ok(bytes)
}

/// `grid` in vtkio's terms.
fn vtk(grid: &Grid) -> Vtk {
    let mut end = 0;
    let offsets = grid.cells.iter().map(|c| {
        end += c.nodes() as u64;
        end
    });
    let piece = UnstructuredGridPiece {
        points: IOBuffer::F64(grid.points.as_flattened().to_vec()),
        cells: Cells {
            cell_verts: VertexNumbers::XML {
                offsets: offsets.collect(),
                connectivity: grid.connectivity.iter().map(|&p| u64::from(p)).collect(),
            },
            types: grid.cells.iter().map(|&c| cell_type(c)).collect(),
        },
        data: Attributes {
            point: grid.point_fields.iter().map(attribute).collect(),
            cell: grid.cell_fields.iter().map(attribute).collect(),
        },
    };
    Vtk {
        // 1.0 is the first version with 64-bit array headers.
        version: Version::new_xml(1, 0),
        title: String::new(),
        byte_order: ByteOrder::LittleEndian,
        data: DataSet::inline(piece),
        file_path: None,
    }
}

/// `field` in vtkio's terms.
fn attribute(field: &Field) -> Attribute {
    let elem = match field.components {
        1 => ElementType::Scalars { num_comp: 1, lookup_table: None },
        3 => ElementType::Vectors,
        n => ElementType::Generic(n as u32), // 6 or 9, checked before
    };
    // VTK's legends stumble over a range that ends at minus zero.
    let data = IOBuffer::F64(field.values.iter().map(|v| v + 0.0).collect());
    Attribute::DataArray(DataArray { name: field.name.clone(), elem, data })
}

/// The name of an array whose values are in the unit of their kind: `bending_stress_MPa`.
fn shop_name(name: &str, kind: Kind) -> String {
    let unit: String = kind.unit.chars().map(|c| if c.is_alphanumeric() { c } else { '_' }).collect();
    format!("{name}_{unit}").trim_end_matches('_').to_string()
}

/// The SI unit in which a kind is written.
fn si_unit(kind: Kind) -> String {
    match kind {
        FORCE => "N".into(),
        STRESS => "Pa".into(),
        MOMENT => "N*m".into(),
        ENERGY => "J".into(),
        kind => kind.canonical().dimension.to_string(),
    }
}

/// `cell` in vtkio's terms.
fn cell_type(cell: Cell) -> CellType {
    match cell {
        Cell::Vertex => CellType::Vertex,
        Cell::Line => CellType::Line,
        Cell::Triangle => CellType::Triangle,
        Cell::Quad => CellType::Quad,
        Cell::QuadraticLine => CellType::QuadraticEdge,
        Cell::QuadraticTriangle => CellType::QuadraticTriangle,
        Cell::QuadraticQuad => CellType::QuadraticQuad,
        Cell::BiquadraticQuad => CellType::BiquadraticQuad,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::{LENGTH, NUMBER};
    use std::error::Error;

    /// One cell of every shape over `points` points, fields with numbers text would lose.
    fn grid(points: usize) -> Grid {
        let mut grid = Grid::default();
        for i in 0..points {
            let t = i as f64;
            grid.points.push([t * 0.1, t.sin(), -1.0 / (t + 3.0)]);
        }
        for (i, cell) in (0..).zip(Cell::ALL) {
            grid.push(cell, &(i..).take(cell.nodes()).collect::<Vec<u32>>());
        }
        let mut scalar: Vec<f64> = (0..points).map(|i| 1.0 / (i as f64 + 1.0)).collect();
        scalar[..4].copy_from_slice(&[-0.0, f64::MAX, f64::MIN_POSITIVE / 3.0, 0.1 + 0.2]);
        let vector = grid.points.iter().map(|p| p.map(|x| x * 1e-9)).collect();
        grid.point_fields =
            vec![Field::scalar("a<b & \"c\"", NUMBER, scalar), Field::vector("displacement", LENGTH, vector)];
        grid.cell_fields = vec![Field::tensor("stress", STRESS, vec![[0.1; 6]; Cell::ALL.len()])];
        grid
    }

    type Array = (String, usize, Vec<u64>);

    /// Name, components and bits of every array of `attributes`.
    fn arrays(attributes: Vec<Attribute>) -> Vec<Array> {
        let read = |attribute| match attribute {
            Attribute::DataArray(a) => {
                let components = a.num_comp();
                Some((a.name, components, bits(&a.data.into_vec()?)))
            }
            Attribute::Field { .. } => None,
        };
        attributes.into_iter().filter_map(read).collect()
    }

    fn bits(values: &[f64]) -> Vec<u64> {
        values.iter().map(|v| v.to_bits()).collect()
    }

    fn expected(fields: &[Field]) -> Vec<Array> {
        let written = |f: &Field| f.values.iter().map(|v| v + 0.0).collect::<Vec<_>>();
        fields.iter().map(|f| (f.name.clone(), f.components, bits(&written(f)))).collect()
    }

    /// 4096 points fill vtkio's compressed blocks of 32768 bytes exactly.
    #[test]
    fn vtkio_reads_back_every_bit() -> Result<(), Box<dyn Error>> {
        for points in [20, 4096] {
            let grid = grid(points);
            let bytes = vtu(&grid)?;
            let DataSet::UnstructuredGrid { pieces, .. } = Vtk::parse_xml(bytes.as_slice())?.data else {
                return Err("not an unstructured grid".into());
            };
            let [piece] = <[_; 1]>::try_from(pieces).map_err(|_| "not one piece")?;
            let piece = piece.into_loaded_piece_data(None)?;
            assert_eq!(piece.points.into_vec().map(|p| bits(&p)), Some(bits(grid.points.as_flattened())));
            let (connectivity, offsets) = piece.cells.cell_verts.into_xml();
            assert_eq!(connectivity, grid.connectivity.iter().map(|&p| u64::from(p)).collect::<Vec<_>>());
            assert_eq!(offsets, [1, 3, 6, 10, 13, 19, 27, 36]);
            assert_eq!(piece.cells.types, Cell::ALL.map(cell_type));
            assert_eq!(arrays(piece.data.point), expected(&grid.point_fields));
            assert_eq!(arrays(piece.data.cell), expected(&grid.cell_fields));
        }
        Ok(())
    }

    #[test]
    fn cell_types_have_vtks_numbers() {
        for cell in Cell::ALL {
            assert_eq!(cell_type(cell) as u8, cell.vtk_id());
        }
    }
}
