//! What all structures of one topology have in common: which freedoms are unknown, and the pattern of their stiffness.

use nalgebra_sparse::{CooMatrix, CscMatrix};

use super::error::StructureError;
use super::{Freedom, Structure, freedoms};
use crate::solve::cholesky::Pattern;

/// What is joined to what, however stiff it is and wherever it stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Topology {
    /// Number of nodes.
    pub nodes: usize,
    /// The nodes that each member joins.
    pub members: Vec<[usize; 2]>,
    /// Of each spring its freedom, and the node from which it stands; `None` is the ground.
    pub springs: Vec<(Freedom, Option<usize>)>,
    /// Freedoms that are held.
    pub held: Vec<Freedom>,
}

/// How structures of one topology are assembled and factored.
pub struct Plan {
    /// Unknown of each freedom that is not held.
    pub(super) unknowns: Vec<Option<usize>>,
    /// The upper triangle of the stiffness over the unknowns, all zero.
    empty: CscMatrix<f64>,
    /// Where in it each entry of members and springs is added up, in the order of [`Topology::entries`]; what is held has no
    /// place.
    places: Vec<Option<usize>>,
    /// The order in which it is factored.
    pub(super) order: Pattern,
}

/// What a spring between two freedoms adds, for its stiffness: to itself and to the other, and between them.
const SHARES: [f64; 4] = [1.0, 1.0, -1.0, -1.0];

impl Topology {
    /// The entries of the stiffness that members and springs have, by the numbers of their freedoms.
    fn entries(&self) -> impl Iterator<Item = (usize, usize)> {
        let of_member = |ends: &[usize; 2]| {
            let all = freedoms(*ends).map(Freedom::number);
            all.into_iter().flat_map(move |a| all.into_iter().map(move |b| (a, b)))
        };
        let of_spring = |(at, from): &(Freedom, Option<usize>)| {
            let own = at.number();
            let other = from.map(|node| Freedom { node, ..*at }.number());
            let between = other.map(|other| [(other, other), (own, other), (other, own)]);
            std::iter::once((own, own)).chain(between.into_iter().flatten())
        };
        self.members.iter().flat_map(of_member).chain(self.springs.iter().flat_map(of_spring))
    }
}

impl Plan {
    /// The plan of a topology.
    ///
    /// # Errors
    /// Memory does not suffice.
    pub fn of(topology: &Topology) -> Result<Self, StructureError> {
        let mut held = vec![false; 3 * topology.nodes];
        topology.held.iter().for_each(|own| held[own.number()] = true);
        let mut count = 0;
        let mut unknown = |held: bool| {
            let own = (!held).then_some(count);
            count += usize::from(!held);
            own
        };
        let unknowns: Vec<Option<usize>> = held.into_iter().map(&mut unknown).collect();
        let entry = |(a, b): (usize, usize)| unknowns[a].zip(unknowns[b]).filter(|(row, column)| row <= column);
        let mut matrix = CooMatrix::new(count, count);
        // Every diagonal entry is there, also of what nothing holds.
        (0..count).for_each(|own| matrix.push(own, own, 0.0));
        topology.entries().filter_map(entry).for_each(|(row, column)| matrix.push(row, column, 0.0));
        let empty = CscMatrix::from(&matrix);
        let place = |(row, column): (usize, usize)| {
            empty.pattern().major_offsets()[column] + empty.pattern().lane(column).partition_point(|own| *own < row)
        };
        let places = topology.entries().map(|own| entry(own).map(place)).collect();
        let order = Pattern::scattered(&empty).map_err(|_| StructureError::OutOfMemory { unknowns: count })?;
        Ok(Self { unknowns, empty, places, order })
    }

    /// Number of unknowns.
    pub(super) fn count(&self) -> usize {
        self.empty.ncols()
    }

    /// The upper triangle of the stiffness of a structure of this topology over the unknowns; N/m, N, N m.
    pub(super) fn assembled(&self, structure: &Structure) -> CscMatrix<f64> {
        let mut upper = self.empty.clone();
        let mut places = self.places.iter();
        let values = upper.values_mut();
        let mut add = |value: f64| {
            if let Some(Some(place)) = places.next() {
                values[*place] += value;
            }
        };
        for (_, member) in &structure.members {
            member.stiffness().iter().for_each(|value| add(*value));
        }
        for spring in &structure.springs {
            let shares = if spring.from.is_some() { &SHARES[..] } else { &SHARES[..1] };
            shares.iter().for_each(|share| add(share * spring.stiffness));
        }
        upper
    }
}
