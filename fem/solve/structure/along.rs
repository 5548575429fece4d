//! What a structure yields with at places along a chain of its members, on which something stands.

use std::collections::HashMap;

use nalgebra::{DMatrix, DVector, RowVector3, RowVector6};

use super::displaced::Load;
use super::factored::Factored;
use super::{Freedom, Structure, freedoms};

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

/// Compliance of what stands on a chain of members, as it is seen there and by other freedoms.
pub struct Along<'s> {
    structure: &'s Structure,
    chain: &'s Chain,
    /// Compliance between the freedoms of each member's ends, and of these with the others.
    ends: Vec<DMatrix<f64>>,
    others: Vec<DMatrix<f64>>,
}

/// What a place of a chain sees; m/N.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// Its displacement under a unit load on it.
    pub own: f64,
    /// The displacements of the other freedoms under that load, and its own under theirs.
    pub others: Vec<f64>,
}

impl<'s> Along<'s> {
    /// The compliance along a chain, and across to some freedoms.
    pub fn new(factored: &'s Factored, chain: &'s Chain, others: &[Freedom]) -> Self {
        let structure = factored.structure();
        // Neighbours share a node, and what a load on it does.
        let mut under: HashMap<Freedom, Vec<f64>> = HashMap::new();
        let of = |member: &usize| {
            let numbers = freedoms(structure.members[*member].0);
            for own in numbers {
                under.entry(own).or_insert_with(|| factored.under(&[(own, 1.0)]));
            }
            let columns = numbers.map(|own| &under[&own]);
            let ends = DMatrix::from_fn(6, 6, |i, j| columns[j][numbers[i].number()]);
            let others = DMatrix::from_fn(others.len(), 6, |i, j| columns[j][others[i].number()]);
            (ends, others)
        };
        let (ends, others) = chain.members.iter().map(of).unzip();
        Self { structure, chain, ends, others }
    }

    /// What is pushed at x (m); `None` where its stand is beyond the ends of the chain.
    pub fn at(&self, x: f64) -> Option<Seen> {
        let (number, part) = self.chain.place(self.structure, x)?;
        let inside = self.structure.members[self.chain.members[number]].1.inside(part);
        // It moves with the member across, and with the member's turning times the way back from its stand.
        let way = RowVector3::new(0.0, 1.0, -self.chain.offset);
        let follows: RowVector6<f64> = way * inside.follows;
        let follows = DVector::from_iterator(6, follows.iter().copied());
        let own = follows.dot(&(&self.ends[number] * &follows)) + (way * inside.yields * way.transpose())[(0, 0)];
        Some(Seen { own, others: (&self.others[number] * &follows).iter().copied().collect() })
    }
}

/// Part of a member by which a place may lie beyond its ends: what is added up of decimals is rounded.
const BEYOND: f64 = 1e-9;
