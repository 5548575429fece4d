//! What a structure yields with at places along a chain of its members.

use nalgebra::{DMatrix, DVector, RowVector6};

use super::factored::Factored;
use super::{Direction, Freedom, Structure};

/// Compliance along a chain of members, in one direction, and across to other freedoms.
pub struct Along<'s> {
    structure: &'s Structure,
    members: Vec<usize>,
    direction: Direction,
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
    /// The compliance along a chain of members, seen in a direction there and by some freedoms.
    pub fn new(factored: &Factored<'s>, chain: &[usize], direction: Direction, others: &[Freedom]) -> Self {
        let structure = factored.structure;
        let of = |member: &usize| {
            let numbers = numbers(structure.members[*member].0);
            let columns: Vec<Vec<f64>> = numbers.iter().map(|own| factored.under(*own)).collect();
            let ends = DMatrix::from_fn(6, 6, |i, j| columns[j][numbers[i].number()]);
            let others = DMatrix::from_fn(others.len(), 6, |i, j| columns[j][others[i].number()]);
            (ends, others)
        };
        let (ends, others) = chain.iter().map(of).unzip();
        Self { structure, members: chain.to_vec(), direction, ends, others }
    }

    /// The place at x (m), on the first member of the chain that reaches there; `None` beyond its ends.
    pub fn at(&self, x: f64) -> Option<Seen> {
        let part = |number: usize| {
            let (ends, member) = &self.structure.members[self.members[number]];
            let part = (x - self.structure.nodes[ends[0]][0]) / member.span[0];
            (-BEYOND..=1.0 + BEYOND).contains(&part).then_some((number, part.clamp(0.0, 1.0)))
        };
        let (number, part) = (0..self.members.len()).find_map(part)?;
        let inside = self.structure.members[self.members[number]].1.inside(part);
        let way = self.direction as usize;
        let follows: RowVector6<f64> = inside.follows.row(way).into_owned();
        let follows = DVector::from_iterator(6, follows.iter().copied());
        let own = follows.dot(&(&self.ends[number] * &follows)) + inside.yields[(way, way)];
        Some(Seen { own, others: (&self.others[number] * &follows).iter().copied().collect() })
    }
}

/// Part of a member by which a place may lie beyond its ends: what is added up of decimals is rounded.
const BEYOND: f64 = 1e-9;

/// The freedoms of the ends of a member.
fn numbers(ends: [usize; 2]) -> [Freedom; 6] {
    let ways = [Direction::X, Direction::Y, Direction::Turn];
    std::array::from_fn(|k| Freedom { node: ends[k / 3], direction: ways[k % 3] })
}
