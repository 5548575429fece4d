//! A structure under loads: its shape, and where its strain energy is.

use nalgebra::{SVector, Vector3};

use super::factored::Factored;
use super::{Freedom, Structure, freedoms};

/// A force within a member.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// The member, by its number.
    pub member: usize,
    /// Part of its length from its first end.
    pub part: f64,
    /// Along x, along y (N), counter-clockwise (N m).
    pub force: [f64; 3],
}

/// A structure as loads displace it.
pub struct Displaced<'f> {
    structure: &'f Structure,
    freedoms: Vec<f64>,
    inside: Vec<Load>,
    /// How far the foot of every spring is moved, m or rad.
    feet: Vec<f64>,
}

impl Factored {
    /// The structure under loads (N, N m) at nodes and within members, of which each bears one at most, and with feet of
    /// springs that are moved, by the numbers of these (m, rad): against the other node or the ground.
    pub fn displaced(&self, at_nodes: &[(Freedom, f64)], inside: &[Load], moved: &[(usize, f64)]) -> Displaced<'_> {
        let structure = self.structure();
        let mut loads = at_nodes.to_vec();
        let mut feet = vec![0.0; structure.springs.len()];
        for (number, by) in moved {
            let spring = &structure.springs[*number];
            feet[*number] = *by;
            // It pushes with what would hold it there.
            let force = spring.stiffness * by;
            loads.push((spring.at, force));
            loads.extend(spring.from.map(|node| (Freedom { node, ..spring.at }, -force)));
        }
        for load in inside {
            let (ends, member) = &structure.members[load.member];
            let carried = member.inside(load.part).follows.transpose() * Vector3::from(load.force);
            loads.extend(freedoms(*ends).into_iter().zip(carried.iter().copied()));
        }
        Displaced { structure, freedoms: self.under(&loads), inside: inside.to_vec(), feet }
    }
}

impl Displaced<'_> {
    /// Displacement of a node along x and y (m) and counter-clockwise (rad).
    pub fn node(&self, node: usize) -> [f64; 3] {
        std::array::from_fn(|k| self.freedoms[3 * node + k])
    }

    fn ends(&self, member: usize) -> SVector<f64, 6> {
        let ends = freedoms(self.structure.members[member].0);
        SVector::from_fn(|k, _| self.freedoms[ends[k].number()])
    }

    fn load(&self, member: usize) -> Option<&Load> {
        self.inside.iter().find(|load| load.member == member)
    }

    /// The line of a member: places (m) and their displacements (m), evenly divided; a force within stands on one of them.
    pub fn line(&self, member: usize, pieces: usize) -> Vec<([f64; 2], [f64; 2])> {
        let ([a, _], own) = self.structure.members[member];
        let (from, ends) = (self.structure.nodes[a], self.ends(member));
        let load = self.load(member);
        let loaded = load.map(|load| {
            let inside = own.inside(load.part);
            inside.follows * ends + inside.yields * Vector3::from(load.force)
        });
        // Beside a force the line is that of a piece whose end is displaced by it.
        let displacement = |part: f64| -> Vector3<f64> {
            let (Some(load), Some(there)) = (load, loaded) else { return own.inside(part).follows * ends };
            let mut of_piece = ends;
            if part <= load.part {
                of_piece.fixed_rows_mut::<3>(3).copy_from(&there);
                let share = if load.part > 0.0 { part / load.part } else { 1.0 };
                return own.piece(load.part).inside(share).follows * of_piece;
            }
            of_piece.fixed_rows_mut::<3>(0).copy_from(&there);
            own.piece(1.0 - load.part).inside((part - load.part) / (1.0 - load.part)).follows * of_piece
        };
        let mut parts: Vec<f64> = (0..=pieces).map(|i| i as f64 / pieces as f64).collect();
        if let Some(load) = load.filter(|load| load.part > 0.0 && load.part < 1.0) {
            // That of the inner places which is nearest moves under the force.
            let nearest = (load.part * pieces as f64).round().clamp(1.0, pieces.max(2) as f64 - 1.0) as usize;
            parts[nearest] = load.part;
        }
        let place = |part: f64| [0, 1].map(|k| from[k] + part * own.span[k]);
        let at = |part: f64| {
            let moved = displacement(part);
            (place(part), [moved[0], moved[1]])
        };
        parts.into_iter().map(at).collect()
    }

    /// Half of force times way of every member and of every joint, J: the strain energy, where a joint is a spring.
    pub fn energies(&self) -> (Vec<f64>, Vec<f64>) {
        let of_member = |member: usize| {
            let (ends, own) = (self.ends(member), self.structure.members[member].1);
            let by_load = self.load(member).map_or(0.0, |load| {
                let force = Vector3::from(load.force);
                force.dot(&(own.inside(load.part).yields * force))
            });
            0.5 * (ends.dot(&(own.stiffness() * ends)) + by_load)
        };
        let of_spring = |(spring, foot): (&super::Spring, &f64)| {
            let way = spring.at.direction as usize;
            let other = spring.from.map_or(0.0, |node| self.node(node)[way]);
            let moved = self.node(spring.at.node)[way] - other;
            0.5 * spring.stiffness * (moved - foot) * moved
        };
        let members = (0..self.structure.members.len()).map(of_member).collect();
        (members, self.structure.springs.iter().zip(&self.feet).map(of_spring).collect())
    }
}
