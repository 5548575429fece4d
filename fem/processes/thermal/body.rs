//! The shape of a heated body.

use std::sync::Arc;

use crate::element::plane::Quad8;
use crate::input::Reader;
use crate::mesh::{Grading, Mesh, RectangleMesh};
use crate::process::Segment;
use crate::units::LENGTH;

/// Elements along a body where nobody says, and at most.
const ALONG_ROD: [f64; 2] = [60.0, 20_000.0];
const ALONG_PLANE: [f64; 2] = [40.0, 2_000.0];
/// Most elements of a rectangle: its factor takes some 300 MB.
pub const MOST_CELLS: f64 = 60_000.0;
/// Least number of elements across a rectangle.
const ACROSS: usize = 4;

/// A body that is heated.
#[derive(Clone, Debug)]
pub enum Body {
    /// Round lengths one after another, from the base on.
    Rod(Vec<Segment>),
    /// A sheet in the plane x, y.
    Plane(Plane),
}

/// A plane body of even width.
#[derive(Clone, Debug)]
pub struct Plane {
    /// Length along x and height along y of a rectangle with a corner at the origin, m; `None` for a mesh
    /// from a file.
    pub size: Option<[f64; 2]>,
    /// Width across the plane, m.
    pub width: f64,
    /// Mesh from a file.
    pub mesh: Option<Arc<Mesh>>,
}

impl Body {
    /// Reads `segments`, `rectangle` or `file` of a table.
    pub fn read(t: &Reader) -> Self {
        let segments = t.list("segments", "a rod: uniform lengths from its base", Segment::read);
        let rectangle = t.optional_table("rectangle", "a plane body with its corner at x = y = 0", |t| Plane {
            size: Some([
                t.quantity("length", LENGTH, "along x").positive().required(),
                t.quantity("height", LENGTH, "along y").positive().required(),
            ]),
            width: t.quantity("width", LENGTH, "across the plane").positive().required(),
            mesh: None,
        });
        let mesh = Mesh::read(t);
        let width = t.quantity("width", LENGTH, "across the plane, of a mesh from a file").positive().optional();
        let given = [!segments.is_empty(), rectangle.is_some(), t.has("file")];
        if given.iter().filter(|g| **g).count() != 1 && !t.is_described() {
            let help = "give one of segments = [{ length, diameter }] (a rod), rectangle = { length, height, width } \
                        and file = \"plate.msh\"";
            t.problem("segments", "a body has one shape", help);
        }
        if t.has("file") && width.is_none() {
            t.problem("file", "a plane body needs its width, across the plane", "add width = \"60 mm\"");
        }
        match (rectangle, mesh) {
            (Some(plane), _) => Self::Plane(plane),
            (None, Some(mesh)) => Self::Plane(Plane { size: None, width: width.unwrap_or(f64::NAN), mesh: Some(mesh) }),
            (None, None) => Self::Rod(segments),
        }
    }

    /// Its smallest and largest x, m; a rod starts at its base.
    pub fn extent(&self) -> [f64; 2] {
        match self {
            Self::Rod(segments) => [0.0, segments.iter().map(|s| s.length).sum()],
            Self::Plane(plane) => plane.extent(0),
        }
    }

    /// Where it ends along x, m from the base.
    pub fn length(&self) -> f64 {
        self.extent()[1]
    }

    /// A plane body.
    pub fn plane(&self) -> Option<&Plane> {
        match self {
            Self::Rod(_) => None,
            Self::Plane(plane) => Some(plane),
        }
    }

    /// Whether it has a section at every x: a mesh from a file has none.
    pub fn has_sections(&self) -> bool {
        self.plane().is_none_or(|plane| plane.size.is_some())
    }

    /// Names of its edges.
    pub fn edges(&self) -> Vec<String> {
        match self {
            Self::Rod(_) => Vec::new(),
            Self::Plane(Plane { mesh: Some(mesh), .. }) => mesh.names().map(str::to_string).collect(),
            Self::Plane(_) => ["left", "right", "top", "bottom"].map(str::to_string).to_vec(),
        }
    }

    /// Whether it has two ends, between which it grows: a mesh from a file has them if it names them.
    pub fn has_ends(&self) -> bool {
        let edges = self.edges();
        matches!(self, Self::Rod(_)) || ["left", "right"].iter().all(|end| edges.iter().any(|e| e == end))
    }

    /// Number of elements of a rectangle none of which is longer than `size` (m), if it is one.
    pub fn cells(&self, size: f64) -> Option<f64> {
        let [length, height] = self.plane()?.size?;
        Some((length / size).ceil().max(1.0) * (height / size).ceil().max(ACROSS as f64))
    }

    /// Elements along it where nobody says, and at most.
    pub fn elements(&self) -> [f64; 2] {
        if matches!(self, Self::Rod(_)) { ALONG_ROD } else { ALONG_PLANE }
    }
}

impl Plane {
    /// Its smallest and largest coordinate along an axis, m.
    pub fn extent(&self, axis: usize) -> [f64; 2] {
        match (&self.size, &self.mesh) {
            (Some(size), _) => [0.0, size[axis]],
            (None, Some(mesh)) => {
                let along = |range: [f64; 2], node: &[f64; 2]| [range[0].min(node[axis]), range[1].max(node[axis])];
                mesh.nodes().iter().fold([f64::INFINITY, f64::NEG_INFINITY], along)
            }
            (None, None) => [0.0, f64::NAN],
        }
    }

    /// Height at which it is looked at where nobody says, m: half way up.
    pub fn middle(&self) -> f64 {
        let [low, high] = self.extent(1);
        0.5 * (low + high)
    }

    /// Its mesh: from the file, or 8-node quadrilaterals no longer than `size` (m), with borders of elements at these
    /// sections (m), where heat comes in and the temperature has a kink.
    ///
    /// # Errors
    /// The rectangle cannot be meshed.
    pub fn mesh(&self, size: f64, sections: &[f64]) -> Result<Arc<Mesh>, String> {
        if let Some(mesh) = &self.mesh {
            return Ok(mesh.clone());
        }
        let [length, height] = self.size.unwrap_or([f64::NAN; 2]);
        let cells = |extent: f64, least: usize| ((extent / size - 1e-9).ceil() as usize).max(least);
        let columns = cells(length, 1).max(sections.len() + 1);
        let uniform = RectangleMesh::uniform([length, height], [columns, cells(height, ACROSS)], &Quad8);
        let along = Grading { toward: sections.to_vec(), ..Grading::uniform() };
        RectangleMesh { along, ..uniform }.build().map(Arc::new).map_err(|error| error.to_string())
    }
}
