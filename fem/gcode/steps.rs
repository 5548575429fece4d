//! A program as steps of its tool: where each ends on the part, which word says so, and what is cut on the way.

use super::arc;
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
}

/// The shape of a cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Straight.
    Line,
    /// Round.
    Arc {
        /// Seen with the part lying from left to right and the tool above.
        is_clockwise: bool,
        /// Its centre.
        centre: Spot,
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
    /// m of radius per unit of words across.
    pub scale: f64,
    /// Where it ends along the part, m, if the program tells.
    pub x: Option<f64>,
    /// Where it ends across, m of radius, if the program tells.
    pub r: Option<f64>,
    /// What is cut.
    pub cut: Option<Cut>,
    /// Whether nothing but a motion to absolute places stands in its block, so that others can be put before it.
    pub is_plain: bool,
}

impl Cut {
    /// Straight pieces along the cut, each from the spot before to the next; those of an arc lie within a hundredth of a micrometre.
    pub fn spots(&self) -> Vec<Spot> {
        match self.shape {
            Shape::Line => vec![self.from, self.to],
            Shape::Arc { is_clockwise, centre, .. } => arc::spots(self.from, self.to, centre, is_clockwise),
        }
    }

    /// Share of the way along the part at a place, 0 at the start.
    pub fn share(&self, x: f64) -> f64 {
        (x - self.from.x) / (self.to.x - self.from.x)
    }
}
