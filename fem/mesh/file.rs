//! The mesh that a model names: `file = "meshes/ring.msh"`, with `unit = "mm"`.

use std::path::PathBuf;
use std::sync::Arc;

use super::{Mesh, read_gmsh};
use crate::input::{Cache, Reader};

/// Largest file, bytes: some millions of nodes.
const LARGEST: u64 = 500_000_000;

/// A Gmsh file has no unit. The default comes first: drawings are in mm.
const UNITS: &[(&str, f64)] = &[("mm", 1e-3), ("cm", 1e-2), ("m", 1.0), ("in", 25.4e-3)];

/// The meshes of a model, by their files and the units of their lengths.
type Meshes = Cache<(PathBuf, f64), Mesh, 4>;

impl Mesh {
    /// Reads the mesh that the keys `file` (Gmsh 4.1, text or binary) and `unit` of a table name, in one
    /// piece and with every element the right way around. `None` where there is no such key, or the problem
    /// is noted; elements and nodes are then named by their tags in the file.
    pub fn read(table: &Reader) -> Option<Arc<Self>> {
        let file = table.file("file", "Gmsh 4.1 mesh", LARGEST);
        let unit = table.choice("unit", "unit of lengths in the file", UNITS).or_first(UNITS[0].1);
        let file = file?;
        let mesh = |_: &_| read_gmsh(&file.bytes, unit);
        match table.kept::<Meshes>().get_or((file.path.clone(), unit), mesh) {
            Ok(mesh) => Some(mesh),
            Err(error) => {
                let help = "mesh it again: one plane body, every element with a positive area, format 4.1";
                table.problem("file", format!("{}: {error}", file.path.display()), help);
                None
            }
        }
    }
}
