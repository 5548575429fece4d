//! Scene of a process, as people would draw it: bodies to scale and arrows for forces. Plain data, SI units, no
//! knowledge of any file format.
//!
//! A frame is a [`Grid`] of what was computed, and bodies that hang on its points: every point of a body's
//! [`Skin`] stands off from a point of the grid and takes displacement and fields from it. So a process that
//! computes a line shows a shaft, and no value is made up between the two.

mod skin;

use std::sync::Arc;

use super::Grid;

pub use skin::{Ends, Skin, SkinPoint};

/// Role of a body in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Role {
    /// The workpiece or slide, made or moved: it has the colours of the shown field.
    Work = 0,
    /// The fixture, jaw or bed that holds it and stands still.
    Machine = 1,
    /// The cutting tool, wheel or heater that works on it.
    Tool = 2,
    /// An arrow of a force.
    Force = 3,
    /// The shape that was meant.
    Nominal = 4,
}

/// From where bodies are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// From the front, a little from above and from the right, with a ghost where nothing is displaced.
    Oblique,
    /// Straight from the front: what happens in a plane.
    Front,
}

/// A body of a frame.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name for people: `shaft`, `jaw`.
    pub name: &'static str,
    /// Role in the picture.
    pub role: Role,
    /// Its surface.
    pub skin: Arc<Skin>,
    /// Whether the cells of the grid show it already, as those of a plane body or a contour do: the surface then gives
    /// it its thickness.
    pub is_computed: bool,
}

impl Body {
    /// A body that no cell of the grid shows.
    pub fn new(name: &'static str, role: Role, skin: impl Into<Arc<Skin>>) -> Self {
        Self { name, role, skin: skin.into(), is_computed: false }
    }

    /// A workpiece that the grid's own cells show already, and to which the surface gives thickness.
    pub fn thickened(name: &'static str, skin: impl Into<Arc<Skin>>) -> Self {
        Self { is_computed: true, ..Self::new(name, Role::Work, skin) }
    }
}

/// An arrow for the field `force` at a point of the grid; it ends before that point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrow {
    /// The point.
    pub node: u32,
    /// Distance from the point to the tip, against the force, m: the radius of a body whose axis the point lies on.
    pub standoff: f64,
    /// Aside from the line of the force, so that a body does not hide it, m.
    pub aside: [f64; 3],
}

impl Arrow {
    /// An arrow on its line.
    pub fn new(node: usize, standoff: f64) -> Self {
        Self { node: node as u32, standoff, aside: [0.0; 3] }
    }
}

/// Everything at one time.
#[derive(Clone, Debug, Default)]
pub struct Frame {
    /// Time, in the terms of [`Animation::time`](super::Animation::time).
    pub time: f64,
    /// Description for people: `tool at x = 312 mm`.
    pub caption: String,
    /// Computed points, cells and fields. `displacement` is the vector by which points move.
    pub grid: Grid,
    /// Bodies that are drawn on its points.
    pub bodies: Vec<Body>,
    /// Forces that are drawn.
    pub arrows: Vec<Arrow>,
}
