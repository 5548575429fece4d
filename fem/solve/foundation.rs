//! A shaft whose supports and whose tool stand on one structure: a force on one moves the others.
//!
//! On supports that are moved by d the shaft leaves the forces Q (and, where a chuck holds its rotation, the moment), and
//! the tool sees w:
//!
//! ```text
//!     Q + S·d = g·P + q        w = C·P + g·d + b
//! ```
//!
//! g the influence, S the constraint, q and b what supports out of line leave. The structure under them yields by their
//! compliance C_s and by c under the tool, which moves by C_t itself, and joints between shaft and structure by e:
//!
//! ```text
//!     d = e + C_s·Q − c·P      gap = w + C_t·P − c·Q
//! ```
//!
//! Q out of these is linear in P and e, so that what is left is of the form from which one began, with
//!
//! ```text
//!     M = (I + S·C_s)⁻¹,   g' = M·(g + S·c),   S' = M·S,   q' = M·q,
//!     C' = C + C_t − g·c + (C_s·g − c)·g',     b' = b + (C_s·g − c)·M·q
//! ```
//!
//! and joints are solved for on a structure as they are on rigid ground.
//!
//! A joint of the structure that is no spring has one in the structure, k, and gives way by e_j besides ([`Seat`]): the
//! spring's foot is moved, F_j = k·(δ_j − e_j), δ_j what the structure moves it by. With B = C_sj·k it moves the supports by
//! B·e_j, and the end joints and all seats obey the same form, F + S·e = g·P + q, with the further rows
//!
//! ```text
//!     g_j = Bᵀ·M·(g + S·c) − k·c_j,   q_j = Bᵀ·M·q,   S_j = Bᵀ·M·S,   S_jj = k − k·C_jj·k + Bᵀ·M·S·B
//! ```

use nalgebra::{DMatrix, DVector};

use super::seated::{MOST_SEATS, resisted};
use crate::joint::Seat;

/// What joints have moved, m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moved {
    /// The shaft at headstock and tailstock, against what these stand on.
    pub ends: [f64; 2],
    /// The seats of the structure, in their order.
    pub seats: [f64; MOST_SEATS],
}

impl From<[f64; 2]> for Moved {
    fn from(ends: [f64; 2]) -> Self {
        Self { ends, ..Self::default() }
    }
}

/// Joints of a structure that give way otherwise than by the springs that stand for them in it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Seats {
    /// By how much they give way beside their springs.
    pub laws: Vec<Seat>,
    /// Their springs, N/m or N m/rad.
    pub stiffness: Vec<f64>,
    /// Displacement of each seat under unit forces on the supports, m/N.
    pub to_supports: DMatrix<f64>,
    /// Displacements under unit pairs of forces on the seats, m/N.
    pub among: DMatrix<f64>,
    /// Displacements of the seats under a unit force on the tool, by position.
    pub cross: Vec<Vec<f64>>,
}

/// What a shaft and its tool stand on: a structure as they see it. Supports are headstock, tailstock, the headstock's
/// turning (counter-clockwise), and the feet of the steady rests; those that there are not, or that stand still, have zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct Foundation {
    /// Displacements of the supports under unit forces on them, m/N, rad/N, rad/(N m); symmetric.
    pub supports: DMatrix<f64>,
    /// Displacements of the supports under a unit force on the tool, by position.
    pub cross: Vec<Vec<f64>>,
    /// Displacement of the tool under a unit force on it, by position, m/N.
    pub tool: Vec<f64>,
    /// Joints in it that are no springs.
    pub seats: Seats,
}

impl Foundation {
    /// This one on another, both of the same positions: each gives way under what stands on them.
    #[must_use]
    pub fn on(mut self, other: &Self) -> Self {
        self.supports += &other.supports;
        for (own, other) in self.cross.iter_mut().zip(&other.cross) {
            own.iter_mut().zip(other).for_each(|(own, other)| *own += other);
        }
        self.tool.iter_mut().zip(&other.tool).for_each(|(own, other)| *own += other);
        self
    }
}

/// How a shaft on rigid supports answers where these are moved.
pub(super) struct Response {
    count: usize,
    /// Deflection by position and support, per unit displacement of the support.
    pub(super) influence: Vec<f64>,
    /// Forces at the supports per unit displacement of each.
    constraint: DMatrix<f64>,
    /// Deflection by position, by supports out of line, m.
    pub(super) bent: Vec<f64>,
    /// Forces that these leave.
    bent_forces: DVector<f64>,
}

impl Response {
    /// Of so many supports that nothing resists.
    pub(super) fn new(count: usize) -> Self {
        let (constraint, bent_forces) = (DMatrix::zeros(count, count), DVector::zeros(count));
        Self { count, influence: Vec::new(), constraint, bent: Vec::new(), bent_forces }
    }

    /// Sets the force at one support per unit displacement of another, and the other way round.
    pub(super) fn set(&mut self, one: usize, other: usize, force: f64) {
        self.constraint[(one, other)] = force;
        self.constraint[(other, one)] = force;
    }

    /// Moves a support for good.
    pub(super) fn move_support(&mut self, support: usize, by: f64) {
        self.bent_forces -= by * self.constraint.column(support);
    }

    fn at(&self, position: usize) -> &[f64] {
        &self.influence[position * self.count..(position + 1) * self.count]
    }

    /// Deflection at a position without a force where supports are moved, m.
    pub(super) fn moved(&self, position: usize, supports: &[f64]) -> f64 {
        self.bent[position] + dot(self.at(position), supports)
    }

    /// Forces on the supports, given their displacements and the tool's force (N) at a position.
    pub(super) fn reactions(&self, tool: usize, force: f64, supports: &[f64]) -> Vec<f64> {
        let resisted = |k: usize| (0..self.count).map(|j| self.constraint[(k, j)] * supports[j]).sum::<f64>();
        (0..self.count).map(|k| self.at(tool)[k] * force + self.bent_forces[k] - resisted(k)).collect()
    }
}

/// A shaft on a foundation: what is left when the supports' displacements are eliminated.
pub(super) struct Founded {
    foundation: Foundation,
    pub(super) response: Response,
    /// M = (I + S·C)⁻¹.
    balance: DMatrix<f64>,
    /// M·S.
    constraint: DMatrix<f64>,
    /// M·q.
    bent_forces: DVector<f64>,
    /// B, what seats move the supports by.
    seats_to_supports: DMatrix<f64>,
    /// The whole S, of headstock, tailstock and seats.
    whole: DMatrix<f64>,
    /// The whole q.
    whole_bent: Vec<f64>,
}

impl Founded {
    pub(super) fn new(foundation: Foundation, response: Response) -> Self {
        let unit = DMatrix::identity(response.count, response.count);
        // Of positive semidefinite S and C the product has no negative eigenvalue, and the sum an inverse.
        let balance = (&unit + &response.constraint * &foundation.supports).try_inverse().unwrap_or(unit);
        let (constraint, bent_forces) = (&balance * &response.constraint, &balance * &response.bent_forces);
        let seats = &foundation.seats;
        let (count, springs) = (seats.laws.len(), &seats.stiffness);
        let moves = DMatrix::from_fn(response.count, count, |s, j| seats.to_supports[(j, s)] * springs[j]);
        let mutual = moves.transpose() * &constraint;
        let among = &mutual * &moves;
        let mut whole = DMatrix::zeros(2 + count, 2 + count);
        for i in 0..2 + count {
            for j in 0..=i {
                let own = match (i.checked_sub(2), j.checked_sub(2)) {
                    // What rounding leaves of a symmetry would be a source of energy.
                    (None, _) => 0.5 * (constraint[(i, j)] + constraint[(j, i)]),
                    (Some(i), None) => mutual[(i, j)],
                    (Some(i), Some(j)) => {
                        let spring = if i == j { springs[i] } else { 0.0 };
                        spring - springs[i] * seats.among[(i, j)] * springs[j] + 0.5 * (among[(i, j)] + among[(j, i)])
                    }
                };
                (whole[(i, j)], whole[(j, i)]) = (own, own);
            }
        }
        let whole = resisted(whole, springs);
        let of_seats = moves.transpose() * &bent_forces;
        let whole_bent = bent_forces.iter().take(2).chain(of_seats.iter()).copied().collect();
        Self { foundation, response, balance, constraint, bent_forces, seats_to_supports: moves, whole, whole_bent }
    }

    /// The laws of its seats.
    pub(super) fn seats(&self) -> &[Seat] {
        &self.foundation.seats.laws
    }

    /// Constraint of headstock, tailstock and seats, and the forces there without the tool.
    pub(super) fn whole(&self) -> (&DMatrix<f64>, &[f64]) {
        (&self.whole, &self.whole_bent)
    }

    /// Influence of headstock, tailstock and seats.
    pub(super) fn whole_influence(&self, position: usize) -> Vec<f64> {
        let (shares, seats) = (self.shares(position), &self.foundation.seats);
        let by_supports = self.seats_to_supports.transpose() * &shares;
        let of_seat = |j: usize| by_supports[j] - seats.stiffness[j] * seats.cross[position][j];
        shares.iter().take(2).copied().chain((0..seats.laws.len()).map(of_seat)).collect()
    }

    /// Constraint of headstock and tailstock, N/m.
    pub(super) fn constraint(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|i| [0, 1].map(|j| self.whole[(i, j)]))
    }

    /// Forces that supports out of line leave at headstock and tailstock, N.
    pub(super) fn bent_forces(&self) -> [f64; 2] {
        [self.bent_forces[0], self.bent_forces[1]]
    }

    /// Forces on all supports under a unit force at a position, where no joint yields.
    fn shares(&self, position: usize) -> DVector<f64> {
        let (own, cross) = (self.response.at(position), &self.foundation.cross[position]);
        let with_tool = &self.response.constraint * DVector::from_column_slice(cross);
        &self.balance * (DVector::from_column_slice(own) + with_tool)
    }

    /// How far the gap follows unit forces on the supports, C_s·g − c.
    fn follows(&self, position: usize) -> DVector<f64> {
        let (own, cross) = (self.response.at(position), &self.foundation.cross[position]);
        &self.foundation.supports * DVector::from_column_slice(own) - DVector::from_column_slice(cross)
    }

    /// Influence of headstock and tailstock, what it adds to the compliance (m/N), and the deflection by supports out of line
    /// (m), at a position.
    pub(super) fn at(&self, position: usize) -> ([f64; 2], f64, f64) {
        let (own, cross) = (self.response.at(position), &self.foundation.cross[position]);
        let (shares, follows) = (self.shares(position), self.follows(position));
        let compliance = self.foundation.tool[position] - dot(own, cross) + follows.dot(&shares);
        ([shares[0], shares[1]], compliance, self.response.bent[position] + follows.dot(&self.bent_forces))
    }

    /// Displacements of all supports with the tool's force (N) at a position, and what joints have moved.
    pub(super) fn supports_under(&self, tool: usize, force: f64, moved: &Moved) -> Vec<f64> {
        let count = self.seats_to_supports.ncols();
        let mut supports = &self.seats_to_supports * DVector::from_column_slice(&moved.seats[..count]);
        supports[0] += moved.ends[0];
        supports[1] += moved.ends[1];
        let forces = self.shares(tool) * force + &self.bent_forces - &self.constraint * &supports;
        let cross = DVector::from_column_slice(&self.foundation.cross[tool]) * force;
        (supports + &self.foundation.supports * forces - cross).as_slice().to_vec()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::element::{BeamPiece, Member};
    use crate::solve::structure::{Along, Chain, Direction, Freedom, Spring, Structure};
    use crate::solve::{Hold, Rest, Shaft};

    const EI: f64 = 4e4;
    const SHEAR: f64 = 6e7;
    /// Chuck on its compliance, or centres.
    const TILT: f64 = 3e-7;

    fn y(node: usize) -> Freedom {
        Freedom { node, direction: Direction::Y }
    }

    /// A bed with a headstock and a tailstock on it, and a place for the foot of a rest; its last node is the bed's.
    fn bed() -> Structure {
        let nodes =
            vec![[-0.2, -0.4], [0.0, -0.4], [0.3, -0.4], [0.8, -0.4], [0.0, 0.0], [0.6, 0.0], [0.7, 0.0], [0.7, -0.4]];
        let members =
            [([0, 1], 3.0), ([1, 2], 3.0), ([2, 7], 3.0), ([7, 3], 3.0), ([1, 4], 8.0), ([7, 6], 5.0), ([6, 5], 1.0)];
        let member = |([a, b], times): ([usize; 2], f64)| {
            let span = [0, 1].map(|k| nodes[b][k] - nodes[a][k]);
            let own = Member { span, axial_rigidity: 8e8, flexural_rigidity: times * 1e6, shear_rigidity: 2e8 };
            ([a, b], own)
        };
        let spring = |node, direction, stiffness| Spring { at: Freedom { node, direction }, from: None, stiffness };
        let springs = vec![spring(0, Direction::Y, 2e8), spring(3, Direction::Y, 1.5e8), spring(0, Direction::X, 1e8)];
        Structure { members: members.map(member).to_vec(), springs, held: Vec::new(), nodes: nodes.clone() }
    }

    /// Machine, shaft and tool as one structure, assembled: a spring in each support, a chuck that tilts or a centre, a rest
    /// on the bed, and the tool on the bed under the place where it cuts.
    fn as_one(x: f64, hold: Hold, rest: Option<f64>) -> f64 {
        let mut whole = bed();
        let first = whole.nodes.len();
        let mut places = vec![0.0, 0.3, 0.6];
        if !places.contains(&x) {
            places.push(x);
        }
        places.sort_by(f64::total_cmp);
        whole.nodes.extend(places.iter().map(|x| [*x, 0.0]));
        for (i, pair) in places.windows(2).enumerate() {
            let span = [pair[1] - pair[0], 0.0];
            let piece = Member { span, axial_rigidity: 1e8, flexural_rigidity: EI, shear_rigidity: SHEAR };
            whole.members.push(([first + i, first + i + 1], piece));
        }
        let at = |x: f64| first + places.iter().position(|own| *own == x).unwrap();
        let mut join = |a, b, direction, stiffness| {
            whole.springs.push(Spring { at: Freedom { node: a, direction }, from: Some(b), stiffness });
        };
        join(at(0.0), 4, Direction::Y, 6e7);
        join(at(0.6), 5, Direction::Y, 4e7);
        join(at(0.0), 4, Direction::X, 1e8);
        if let Hold::Compliance(tilt) = hold {
            join(at(0.0), 4, Direction::Turn, 1.0 / tilt);
        }
        if let Some(stiffness) = rest {
            join(at(0.3), 2, Direction::Y, stiffness);
        }
        let work = y(at(x));
        let factored = whole.factored().unwrap();
        let chain = Chain { members: vec![0, 1, 2, 3], offset: 0.0 };
        let of_work = factored.under(&[(work, 1.0)]);
        let there = Along::new(&factored, &chain).at(x, [&of_work[..]]).unwrap();
        factored.compliance(&[work])[(0, 0)] + there.own - 2.0 * there.others[0]
    }

    /// The same shaft, condensed on the same bed.
    fn condensed(x: f64, hold: Hold, rest: Option<f64>) -> f64 {
        let piece = BeamPiece { length: 0.6, flexural_rigidity: EI, shear_rigidity: SHEAR };
        let rests = rest.map(|stiffness| Rest { at: 0.3, stiffness, offset: 0.0 }).into_iter().collect();
        let shaft = Shaft { pieces: vec![piece], hold, tailstock: true, rests };
        let bed = bed().factored().unwrap();
        let turn = Freedom { node: 4, direction: Direction::Turn };
        let ports = [vec![y(4), y(5), turn], rest.map(|_| y(2)).into_iter().collect()].concat();
        let chain = Chain { members: vec![0, 1, 2, 3], offset: 0.0 };
        let seen = Along::new(&bed, &chain).at(x, bed.under_each(&ports).iter().map(Vec::as_slice)).unwrap();
        let across = seen.others.clone();
        let (supports, seats) = (bed.compliance(&ports), Seats::default());
        let foundation = Foundation { supports, cross: vec![seen.others], tool: vec![seen.own], seats };
        let shaft = shaft.condense_on(&[x], foundation).unwrap();
        let joints = [1.0 / 6e7, 1.0 / 4e7].map(|k| crate::joint::Joint { spring_compliance: k, contacts: Vec::new() });
        let joints = joints.each_ref().map(crate::joint::Rubbing::free);
        let supports =
            crate::solve::solve_joints(&joints, shaft.influence[0], &shaft.constraint, (1.0, shaft.bent_forces), None);
        let ends = supports.unwrap().displacements;
        let moved = Moved::from(ends);
        let line = shaft.line(0, 1.0, &moved)[0];
        let gap = shaft.compliance[0] + shaft.foundation_compliance[0] + shaft.moved(0, ends);
        // Work and tool apart, by way of the supports.
        let supports = shaft.supports_under(0, 1.0, &moved);
        let reactions = shaft.reactions_under(0, 1.0, &moved).unwrap();
        assert_eq!(supports.len(), ports.len());
        let tool: f64 = -seen.own + across.iter().zip(&reactions).map(|(c, q)| c * q).sum::<f64>();
        assert!((line - tool - gap).abs() < 1e-10 * gap, "{line} {tool} {gap}");
        gap
    }

    #[test]
    fn a_shaft_on_a_structure_is_one_structure() {
        for hold in [Hold::Free, Hold::Compliance(TILT)] {
            for rest in [None, Some(3e7)] {
                for x in [0.0, 0.11, 0.3, 0.47, 0.6] {
                    let (found, expected) = (condensed(x, hold, rest), as_one(x, hold, rest));
                    assert!((found / expected - 1.0).abs() < 1e-9, "{hold:?} {rest:?} {x}: {found} {expected}");
                }
            }
        }
    }
}
