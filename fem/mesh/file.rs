//! The mesh that a model names: `file = "meshes/ring.msh"`, with `unit = "mm"`.

use std::sync::{Arc, Mutex, PoisonError};

use super::{Mesh, read_gmsh};
use crate::input::Reader;

/// Largest file, bytes: some millions of nodes.
const LARGEST: u64 = 500_000_000;
/// Meshes kept: a search reads the same model again and again.
const MOST_MESHES: usize = 4;

/// A Gmsh file has no unit. The default comes first: drawings are in mm.
const UNITS: &[(&str, f64)] = &[("mm", 1e-3), ("cm", 1e-2), ("m", 1.0), ("in", 25.4e-3)];

/// A file's content with the unit of its lengths, and the mesh that it is.
type Known = (Arc<[u8]>, f64, Arc<Mesh>);

static RECENT: Mutex<Vec<Known>> = Mutex::new(Vec::new());

impl Mesh {
    /// Reads the mesh that the keys `file` (Gmsh 4.1, text or binary) and `unit` of a table name, in one piece and with every element the right way around.
    /// `None` where there is no such key, or the problem is noted; elements and nodes are then named by their tags in the file.
    pub fn read(table: &Reader) -> Option<Arc<Self>> {
        let file = table.file("file", "Gmsh 4.1 mesh", LARGEST);
        let unit = table.choice("unit", "unit of lengths in the file", UNITS).or_first(UNITS[0].1);
        let file = file?;
        // A panic while the list was held leaves it whole: entries are added and removed in one step each.
        let recent = || RECENT.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((.., mesh)) = recent().iter().find(|(bytes, u, _)| *u == unit && *bytes == file.bytes) {
            return Some(mesh.clone());
        }
        match read_gmsh(&file.bytes, unit) {
            Ok(mesh) => {
                let mesh = Arc::new(mesh);
                let mut list = recent();
                if list.len() >= MOST_MESHES {
                    list.remove(0);
                }
                list.push((file.bytes, unit, mesh.clone()));
                Some(mesh)
            }
            Err(error) => {
                let help = "mesh it again: one plane body, every element with a positive area, format 4.1";
                table.problem("file", format!("{}: {error}", file.path.display()), help);
                None
            }
        }
    }
}
