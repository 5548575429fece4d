//! A program as steps of its tool: where each ends on the part, which word says so, and what is cut on the way.

use super::arc::{self, Point};
use super::spot::Spot;

/// A way through the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// Where it begins.
    pub from: Spot,
    /// Where it ends.
    pub to: Spot,
    /// How.
    pub shape: Shape,
    /// Whether the control moves it aside by a radius that is not in the program (G41, G42).
    pub is_aside: bool,
}

/// The shape of a cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Straight.
    Line,
    /// Round.
    Arc {
        /// As it is seen in the plane of the machine's arcs.
        is_clockwise: bool,
        /// Its centre, in the plane of the machine's arcs.
        centre: Point,
        /// How the centre is written.
        written: Centre,
    },
}

/// How the centre of an arc is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Centre {
    /// By the radius: it follows both ends.
    Radius,
    /// From the start, with which it moves.
    FromStart,
    /// From the zero: it stays.
    Absolute,
}

/// A block that moves, or after which nobody knows where the tool is.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The block, by its position.
    pub block: usize,
    /// The word, by its position in the block, that says where it ends across the part.
    pub word: Option<usize>,
    /// Whether that counts on from where the tool stands.
    pub is_on: bool,
    /// m per unit of words along the part.
    pub unit: f64,
    /// m of the level per unit of words across.
    pub scale: f64,
    /// The level at which it ends, m, if the program tells.
    pub r: Option<f64>,
    /// What is cut.
    pub cut: Option<Cut>,
    /// Whether nothing but a motion to absolute places stands in its block, so that others can be put before it.
    pub is_plain: bool,
}

impl Cut {
    /// Straight pieces of the profile along a cut of a lathe, each from the spot before to the next; those of an arc
    /// lie within a hundredth of a micrometre.
    pub fn profile(&self) -> Vec<Spot> {
        match self.shape {
            Shape::Line => vec![self.from, self.to],
            Shape::Arc { is_clockwise, centre, .. } => {
                let [from, to] = [self.from, self.to].map(|spot| [spot.x, spot.r]);
                let points = arc::points(from, to, centre, is_clockwise);
                points.into_iter().map(|[x, r]| Spot { x, r, y: self.from.y }).collect()
            }
        }
    }

    /// The spot at a share of its straight way, 0 at the start.
    pub fn at(&self, share: f64) -> Spot {
        self.from.toward(self.to, share)
    }

    /// Its straight way along the part, m.
    pub fn way(&self) -> f64 {
        (self.to.x - self.from.x).hypot(self.to.y - self.from.y)
    }

    /// Share of the way at a place along the part, 0 at the start.
    pub fn share(&self, x: f64) -> f64 {
        (x - self.from.x) / (self.to.x - self.from.x)
    }
}
