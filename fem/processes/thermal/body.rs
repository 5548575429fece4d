//! The shape of a heated body.

use std::f64::consts::PI;
use std::sync::Arc;

use super::revolved;
use crate::element::plane::{Quad8, Thickness};
use crate::input::Reader;
use crate::mesh::{Grading, LEFT, Mesh, RIGHT, RectangleMesh};
use crate::process::Segment;
use crate::units::LENGTH;

/// Elements along a body where nobody says, and at most.
const ALONG_ROD: [f64; 2] = [60.0, 20_000.0];
const ALONG_PLANE: [f64; 2] = [40.0, 2_000.0];
/// Most elements of a plane body: its factors and pictures take less than a gigabyte.
pub const MOST_CELLS: f64 = 50_000.0;
/// Least number of elements across a rectangle.
const ACROSS: usize = 4;

/// A body that is heated.
#[derive(Clone, Debug)]
pub enum Body {
    /// Round lengths one after another, from the base on.
    Rod(Vec<Segment>),
    /// A body in the plane x, y: a sheet, or the half section of a body of revolution.
    Plane(Plane),
}

/// A body in a plane.
#[derive(Clone, Debug)]
pub struct Plane {
    /// Its outline in the plane.
    pub outline: Outline,
    /// The body across the plane.
    pub thickness: Thickness,
}

/// Outline of a body in a plane.
#[derive(Clone, Debug)]
pub enum Outline {
    /// Length along x and height along y of a rectangle with a corner at the origin, m.
    Rectangle([f64; 2]),
    /// A mesh from a file.
    Mesh(Arc<Mesh>),
    /// The half section of round lengths one after another: x along their axis, y the radius.
    Revolved(Vec<Segment>),
}

/// The coordinate along which an edge of this name reaches: 0 for x, 1 for y.
pub fn axis_of(edge: &str) -> usize {
    usize::from(matches!(edge, LEFT | RIGHT))
}

impl Body {
    /// Reads `segments`, `rectangle`, `revolved` or `file` of a table.
    pub fn read(t: &Reader) -> Self {
        let segments = t.list("segments", "a rod: uniform lengths from its base", Segment::read);
        let rectangle = t.optional_table("rectangle", "a plane body with its corner at x = y = 0", |t| Plane {
            outline: Outline::Rectangle([
                t.quantity("length", LENGTH, "along x").positive().required(),
                t.quantity("height", LENGTH, "along y").positive().required(),
            ]),
            thickness: Thickness::Uniform(t.quantity("width", LENGTH, "across the plane").positive().required()),
        });
        let walls = revolved::read(t);
        let mesh = Mesh::read(t);
        let width = t.quantity("width", LENGTH, "across the plane, of a mesh from a file").positive().optional();
        let given = [!segments.is_empty(), rectangle.is_some(), !walls.is_empty(), t.has("file")];
        if given.iter().filter(|g| **g).count() != 1 && !t.is_described() {
            let help = "give one of segments = [{ length, diameter }] (a rod), rectangle = { length, height, width }, \
                        revolved = [{ length, diameter, bore }] (a body of revolution) and file = \"plate.msh\"";
            t.problem("segments", "a body has one shape", help);
        }
        if t.has("file") && width.is_none() {
            t.problem("file", "a plane body needs its width, across the plane", "add width = \"60 mm\"");
        }
        if width.is_some() && !t.has("file") {
            let help = "leave it out: a rectangle has its own, and a rod or a body of revolution none";
            t.problem("width", "`width` is of a mesh from a file", help);
        }
        match (rectangle, mesh) {
            (Some(plane), _) => Self::Plane(plane),
            (None, Some(mesh)) => {
                let thickness = Thickness::Uniform(width.unwrap_or(f64::NAN));
                Self::Plane(Plane { outline: Outline::Mesh(mesh), thickness })
            }
            (None, None) if !walls.is_empty() && segments.is_empty() => {
                Self::Plane(Plane { outline: Outline::Revolved(walls), thickness: Thickness::Revolved })
            }
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

    /// A body in a plane: a sheet, or a body of revolution.
    pub fn plane(&self) -> Option<&Plane> {
        match self {
            Self::Rod(_) => None,
            Self::Plane(plane) => Some(plane),
        }
    }

    /// The lengths of a body of revolution.
    pub fn revolved(&self) -> Option<&[Segment]> {
        match &self.plane()?.outline {
            Outline::Revolved(walls) => Some(walls),
            Outline::Rectangle(_) | Outline::Mesh(_) => None,
        }
    }

    /// What it is called, with its article.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Rod(_) => "a rod",
            Self::Plane(plane) if plane.thickness.is_revolved() => "a body of revolution",
            Self::Plane(_) => "a plane body",
        }
    }

    /// What many of it are called.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Rod(_) => "rods",
            Self::Plane(plane) if plane.thickness.is_revolved() => "bodies of revolution",
            Self::Plane(_) => "plane bodies",
        }
    }

    /// Whether it has a section at every x: a mesh from a file has none.
    pub fn has_sections(&self) -> bool {
        self.plane().is_none_or(|plane| !matches!(plane.outline, Outline::Mesh(_)))
    }

    /// Names of its edges.
    pub fn edges(&self) -> Vec<String> {
        let Some(plane) = self.plane() else { return Vec::new() };
        match &plane.outline {
            Outline::Mesh(mesh) => mesh.names().map(str::to_string).collect(),
            Outline::Rectangle(_) => ["left", "right", "top", "bottom"].map(str::to_string).to_vec(),
            Outline::Revolved(walls) => revolved::edges(walls),
        }
    }

    /// Whether it has two ends, between which it grows: a mesh from a file has them if it names them.
    pub fn has_ends(&self) -> bool {
        let edges = self.edges();
        matches!(self, Self::Rod(_)) || ["left", "right"].iter().all(|end| edges.iter().any(|e| e == end))
    }

    /// Number of elements none of which is longer than `size` (m), if the mesh is the program's own.
    pub fn cells(&self, size: f64) -> Option<f64> {
        match &self.plane()?.outline {
            Outline::Rectangle([length, height]) => {
                Some((length / size).ceil().max(1.0) * (height / size).ceil().max(ACROSS as f64))
            }
            Outline::Revolved(walls) => Some(revolved::mesh(walls, size, &[]).cells()),
            Outline::Mesh(_) => None,
        }
    }

    /// Longest element where nobody says, and the length of elements that would be too many, m.
    pub fn sizes(&self) -> [f64; 2] {
        let [usual, most] = if matches!(self, Self::Rod(_)) { ALONG_ROD } else { ALONG_PLANE };
        let reach = self.revolved().map_or(self.length(), |walls| self.length().max(revolved::height(walls)));
        [reach / usual, self.length() / most]
    }
}

impl Plane {
    /// Its smallest and largest coordinate along an axis, m.
    pub fn extent(&self, axis: usize) -> [f64; 2] {
        match &self.outline {
            Outline::Rectangle(size) => [0.0, size[axis]],
            Outline::Mesh(mesh) => {
                let along = |range: [f64; 2], node: &[f64; 2]| [range[0].min(node[axis]), range[1].max(node[axis])];
                mesh.nodes().iter().fold([f64::INFINITY, f64::NEG_INFINITY], along)
            }
            Outline::Revolved(walls) if axis == 0 => [0.0, walls.iter().map(|wall| wall.length).sum()],
            Outline::Revolved(walls) => revolved::radii(walls),
        }
    }

    /// Its smallest and largest y (m) at some x: of a body of revolution its radii there.
    pub fn extent_at(&self, x: f64) -> [f64; 2] {
        match &self.outline {
            Outline::Revolved(walls) => revolved::radii_at(walls, x),
            Outline::Rectangle(_) | Outline::Mesh(_) => self.extent(1),
        }
    }

    /// Half way up a sheet, m.
    pub fn middle(&self) -> f64 {
        let [low, high] = self.extent(1);
        0.5 * (low + high)
    }

    /// y (m) at which it is looked at where nobody says: half way up a sheet, on the outside of a body of revolution.
    pub fn usual_y(&self, x: f64) -> f64 {
        if self.thickness.is_revolved() { self.extent_at(x)[1] } else { self.middle() }
    }

    /// Area of the section at its base, m².
    pub fn base_area(&self) -> f64 {
        let [low, high] = self.extent_at(0.0);
        match self.thickness {
            Thickness::Uniform(width) => (high - low) * width,
            Thickness::Revolved => PI * (high * high - low * low),
        }
    }

    /// Its thickness in pictures, m: a body of revolution is shown by a thin slice.
    pub fn shown_thickness(&self) -> f64 {
        /// Of the slice, as a part of the largest radius.
        const SLICE: f64 = 0.05;
        match self.thickness {
            Thickness::Uniform(width) => width,
            Thickness::Revolved => SLICE * self.extent(1)[1],
        }
    }

    /// Its mesh: from the file, or 8-node quadrilaterals no longer than `size` (m), with borders of elements at these
    /// sections (m), where heat comes in and the temperature has a kink.
    ///
    /// # Errors
    /// The outline cannot be meshed.
    pub fn mesh(&self, size: f64, sections: &[f64]) -> Result<Arc<Mesh>, String> {
        let mesh = match &self.outline {
            Outline::Mesh(mesh) => return Ok(mesh.clone()),
            Outline::Revolved(walls) => revolved::mesh(walls, size, sections).build(),
            Outline::Rectangle([length, height]) => {
                let cells = |extent: f64, least: usize| ((extent / size - 1e-9).ceil() as usize).max(least);
                let columns = cells(*length, 1).max(sections.len() + 1);
                let uniform = RectangleMesh::uniform([*length, *height], [columns, cells(*height, ACROSS)], &Quad8);
                let along = Grading { toward: sections.to_vec(), ..Grading::uniform() };
                RectangleMesh { along, ..uniform }.build()
            }
        };
        mesh.map(Arc::new).map_err(|error| error.to_string())
    }
}
