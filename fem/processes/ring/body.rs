//! The ring as plane elements: equal cells, or a mesh from a file.

use std::sync::Arc;

use super::drawn::{Drawn, Held};
use super::response::MeshSize;
use crate::input::{Cache, Reader};
use crate::mesh::Mesh;
use crate::units::LENGTH;

/// Most elements: more than any ring needs, and its factor and pictures take less than a gigabyte.
const MOST_ELEMENTS: usize = 40_000;
/// Elements from jaw to jaw, at least.
const LEAST_PER_JAW: usize = 8;

/// The ring as plane elements.
#[derive(Clone, Debug)]
pub enum Body {
    /// Equal cells between two circles.
    Cells(MeshSize),
    /// A mesh from a file.
    Drawn(Arc<Drawn>),
}

/// Reads the mesh of a ring in so many jaws, of these radii (m).
pub fn read(model: &Reader, jaws: usize, radii: [Option<f64>; 2]) -> Body {
    let usual = MeshSize { circumferential: 360.max(LEAST_PER_JAW * jaws), radial: usual_radial(radii), order: 2 };
    let read = |t: &Reader| {
        let size = read_cells(t, jaws, usual.radial);
        match Mesh::read(t) {
            Some(mesh) => read_drawn(t, mesh, jaws, radii).map_or(Body::Cells(size), Body::Drawn),
            None => Body::Cells(size),
        }
    };
    model.optional_table("mesh", "the ring as plane elements", read).unwrap_or(Body::Cells(usual))
}

/// Elements across the wall: six, and more where the bore is so small that stresses change much within a
/// sixth of the wall.
fn usual_radial(radii: [Option<f64>; 2]) -> usize {
    const PER_BORE_RADIUS: f64 = 3.0;
    let [Some(outer), Some(inner)] = radii else { return 6 };
    let cells = PER_BORE_RADIUS * (outer - inner) / inner;
    if cells.is_finite() { (cells.ceil() as usize).clamp(6, 100) } else { 6 }
}

/// The ring of a mesh from a file, if that is one.
fn read_drawn(t: &Reader, mesh: Arc<Mesh>, jaws: usize, radii: [Option<f64>; 2]) -> Option<Arc<Drawn>> {
    if let Some(key) = ["circumferential", "radial", "order"].into_iter().find(|key| t.has(key)) {
        let message = format!("`{key}` is of a mesh of equal cells, and `file` names another");
        t.problem(key, message, "leave one of them out");
    }
    if mesh.element_count() > MOST_ELEMENTS {
        t.problem("file", format!("the mesh has more than {MOST_ELEMENTS} elements"), "a coarser mesh is as good");
        return None;
    }
    let known = t.kept::<Cache<Held, Drawn, 4>>();
    let drawn = known.get_or(Held { mesh, jaws }, |held| Drawn::new(&held.mesh, jaws)).map_err(|message| {
        let help = "a ring has its centre at the origin, the sides `bore`, and jaws `jaw-1`, `jaw-2` … on a circle";
        t.problem("file", format!("the mesh is no ring in {jaws} jaws: {message}"), help);
    });
    let drawn = drawn.ok()?;
    for (given, drawn, what) in [(radii[0], drawn.outer_radius, "outer"), (radii[1], drawn.inner_radius, "inner")] {
        if let Some(given) = given.filter(|given| (given / drawn - 1.0).abs() > 1e-3) {
            let (given, drawn) = (LENGTH.shown(2.0 * given), LENGTH.shown(2.0 * drawn));
            let message = format!("the mesh has an {what} diameter of {drawn:.4}, [workpiece] one of {given:.4}");
            t.problem("file", message, "leave the diameter out, or say in which `unit` the mesh is");
        }
    }
    Some(drawn)
}

fn read_cells(t: &Reader, jaws: usize, radial: usize) -> MeshSize {
    let size = MeshSize {
        circumferential: t.count("circumferential", "elements around").between(16, 100_000).or(360),
        radial: t.count("radial", "elements across the wall").between(1, 1000).or(radial),
        order: t.count("order", "1 for 4-node, 2 for 8-node quadrilaterals").between(1, 2).or(2),
    };
    let elements = size.circumferential * size.radial;
    if elements > MOST_ELEMENTS {
        let message = format!("{} by {} elements are more than {MOST_ELEMENTS}", size.circumferential, size.radial);
        t.problem("circumferential", message, "360 around and 6 across are good to a part in ten thousand");
    }
    if size.circumferential < LEAST_PER_JAW * jaws {
        let message = format!("{} elements around are too few for {jaws} jaws", size.circumferential);
        let least = LEAST_PER_JAW * jaws;
        t.problem("circumferential", message, format!("take at least {least}: {LEAST_PER_JAW} from jaw to jaw"));
    }
    size
}
