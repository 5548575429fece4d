//! What a structure yields with at places along a chain of its members, on which something stands.

use nalgebra::{RowVector3, SMatrix};

use super::displaced::Load;
use super::factored::Factored;
use super::{Structure, freedoms};

/// Members along x, and what stands on them: it is pushed along y at x, and stands at x + offset, turning with the member
/// there.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The members, by their numbers.
    pub members: Vec<usize>,
    /// From where it is pushed to where it stands, m.
    pub offset: f64,
}

impl Chain {
    /// Number in the chain and part of the member on which something that is pushed at x (m) stands; `None` beyond the ends.
    fn place(&self, structure: &Structure, x: f64) -> Option<(usize, f64)> {
        let part = |number: usize| {
            let (ends, member) = &structure.members[self.members[number]];
            let part = (x + self.offset - structure.nodes[ends[0]][0]) / member.span[0];
            (-BEYOND..=1.0 + BEYOND).contains(&part).then_some((number, part.clamp(0.0, 1.0)))
        };
        (0..self.members.len()).find_map(part)
    }

    /// What a force (N) along y at x (m) does to the member on which its point of action stands.
    pub fn load(&self, structure: &Structure, x: f64, force: f64) -> Option<Load> {
        let (number, part) = self.place(structure, x)?;
        Some(Load { member: self.members[number], part, force: [0.0, force, -self.offset * force] })
    }
}

/// Compliance of what stands on a chain of members, and what it follows.
pub struct Along<'s> {
    structure: &'s Structure,
    chain: &'s Chain,
    /// Compliance between the freedoms of each member's ends.
    ends: Vec<SMatrix<f64, 6, 6>>,
}

/// What a place of a chain sees.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// Its displacement under a unit load on it, m/N.
    pub own: f64,
    /// Its displacements where all freedoms are displaced, of unit loads what these see of a unit load on it.
    pub others: Vec<f64>,
}

impl<'s> Along<'s> {
    /// The compliance along a chain.
    pub fn new(factored: &'s Factored, chain: &'s Chain) -> Self {
        Self { structure: factored.structure(), chain, ends: factored.of_ends(&chain.members) }
    }

    /// What is pushed at x (m), and follows each of these displacements of all freedoms; `None` where its stand is beyond the
    /// ends of the chain.
    pub fn at<'d>(&self, x: f64, displaced: impl IntoIterator<Item = &'d [f64]>) -> Option<Seen> {
        let (number, part) = self.chain.place(self.structure, x)?;
        let (ends, member) = &self.structure.members[self.chain.members[number]];
        let (numbers, inside) = (freedoms(*ends), member.inside(part));
        // It moves with the member across, and with the member's turning times the way back from its stand.
        let way = RowVector3::new(0.0, 1.0, -self.chain.offset);
        let follows = way * inside.follows;
        let own = (follows * self.ends[number] * follows.transpose() + way * inside.yields * way.transpose())[(0, 0)];
        let of_other = |moved: &[f64]| numbers.iter().zip(&follows).map(|(at, share)| share * moved[at.number()]).sum();
        Some(Seen { own, others: displaced.into_iter().map(of_other).collect() })
    }
}

/// Part of a member by which a place may lie beyond its ends: what is added up of decimals is rounded.
const BEYOND: f64 = 1e-9;
