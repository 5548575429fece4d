//! Plane structures of members and springs, and how they yield at the places that others press on.
//!
//! A structure is factored once; what presses on it sees the compliance between a few of its freedoms (its Schur
//! complement, inverted), and along members the compliance at any place, so that a sweep along a bed costs a few
//! products a place.

mod along;
mod displaced;
mod error;
mod factored;
mod plan;

pub use along::{Along, Chain, Seen};
pub use displaced::{Displaced, Load};
pub use error::StructureError;
pub use factored::Factored;
pub use plan::{Plan, Topology};

use crate::element::Member;

/// A displacement of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// Along x, m.
    X,
    /// Along y, m.
    Y,
    /// Counter-clockwise, rad.
    Turn,
}

/// A node and one of its displacements.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Freedom {
    /// The node, by its number.
    pub node: usize,
    /// The displacement.
    pub direction: Direction,
}

impl Freedom {
    /// Its number among all: u, v, θ of node i at 3i, 3i + 1, 3i + 2.
    pub fn number(self) -> usize {
        3 * self.node + self.direction as usize
    }
}

/// The freedoms of the ends of a member: u, v, θ of the first and of the second.
fn freedoms(ends: [usize; 2]) -> [Freedom; 6] {
    let ways = [Direction::X, Direction::Y, Direction::Turn];
    std::array::from_fn(|k| Freedom { node: ends[k / 3], direction: ways[k % 3] })
}

/// A spring against the displacement of a node in one direction, from the ground or from another node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// The node and the direction.
    pub at: Freedom,
    /// The other node; `None` is the ground.
    pub from: Option<usize>,
    /// Stiffness, N/m or N m/rad.
    pub stiffness: f64,
}

/// Nodes with the members and springs between them. All in SI, in one plane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Structure {
    /// Places of the nodes, x and y (m).
    pub nodes: Vec<[f64; 2]>,
    /// The nodes that each member joins, and the member.
    pub members: Vec<([usize; 2], Member)>,
    /// Springs.
    pub springs: Vec<Spring>,
    /// Freedoms that are held.
    pub held: Vec<Freedom>,
}

impl Structure {
    /// What is joined to what in it.
    pub fn topology(&self) -> Topology {
        Topology {
            nodes: self.nodes.len(),
            members: self.members.iter().map(|(ends, _)| *ends).collect(),
            springs: self.springs.iter().map(|spring| (spring.at, spring.from)).collect(),
            held: self.held.clone(),
        }
    }

    /// Assembles and factors.
    ///
    /// # Errors
    /// Something can move without resistance, or memory does not suffice.
    pub fn factored(self) -> Result<Factored, StructureError> {
        let plan = Plan::of(&self.topology())?;
        Factored::new(self, plan.into())
    }
}

#[cfg(test)]
mod tests;
