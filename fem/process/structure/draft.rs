//! A structure in the making: as it is drawn, with nodes put in where something stands within a member.

use std::collections::HashMap;

use crate::input::{Cache, Name, Reader};
use crate::joint::Seat;
use crate::process::Failure;
use crate::solve::JointsError;
use crate::solve::structure::{Direction, Factored, Freedom, Plan, Structure, StructureError, Topology};
use crate::units::{FORCE, LENGTH};

/// What something stands on.
#[derive(Clone, Debug, PartialEq)]
pub enum Stand {
    /// A node, by its number.
    Node(usize),
    /// Members along x, by their names: it stands at its own place on them.
    Along(Vec<Name>),
}

/// A place at which something pushes or looks: at a node, against another one or the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Port {
    /// The node and the direction.
    pub at: Freedom,
    /// The node against which it stands; `None` is the ground.
    pub from: Option<usize>,
}

impl Port {
    /// What a force (N) does that acts between its two sides.
    pub fn forces(&self, force: f64) -> Vec<(Freedom, f64)> {
        let back = self.from.map(|node| (Freedom { node, ..self.at }, -force));
        std::iter::once((self.at, force)).chain(back).collect()
    }
}

/// A structure as a model draws it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    pub(super) structure: Structure,
    pub(super) nodes: Vec<Name>,
    /// How many of them the model draws; those behind were put into members, whose names they have.
    pub(super) drawn: usize,
    /// Of every member of the structure, that of which it is a piece.
    pub(super) members: Vec<Name>,
    /// Width and height of every member, as it is drawn, m.
    pub(super) sizes: Vec<[f64; 2]>,
    /// Of every spring.
    pub(super) joints: Vec<Name>,
    /// Springs, by their numbers, whose joints give way beside them, and whether they are pressed along their direction.
    pub(super) seats: Vec<DrawnSeat>,
}

/// A joint that gives way beside its spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawnSeat {
    /// Number of the spring.
    pub spring: usize,
    /// 1 where it is pressed as its node moves along its direction, −1 where against it.
    pub sign: f64,
    /// By how much it gives way.
    pub law: Seat,
}

/// A structure that is factored, with the names of its parts.
pub struct Drawn {
    /// Of every node; one that was put into a member has the member's.
    pub nodes: Vec<Name>,
    /// The structure.
    pub factored: Factored,
    /// Of every member of the structure, that of which it is a piece.
    pub members: Vec<Name>,
    /// Width across the plane and height in it of every member, m.
    pub sizes: Vec<[f64; 2]>,
    /// Of every spring.
    pub joints: Vec<Name>,
    /// Joints that give way beside their springs.
    pub seats: Vec<DrawnSeat>,
}

/// Its parts by their names: what is factored is of no use to a reader.
impl std::fmt::Debug for Drawn {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { nodes, members, joints, .. } = self;
        f.debug_struct("Drawn")
            .field("nodes", nodes)
            .field("members", members)
            .field("joints", joints)
            .finish_non_exhaustive()
    }
}

impl Drawn {
    /// A unit pair of forces that presses a seat.
    pub fn pair(&self, seat: &DrawnSeat) -> Vec<(Freedom, f64)> {
        let spring = &self.factored.structure().springs[seat.spring];
        Port { at: spring.at, from: spring.from }.forces(seat.sign)
    }

    /// Feet of springs that seats have moved (m), by the numbers of the springs.
    pub fn feet(&self, moved: &[f64]) -> Vec<(usize, f64)> {
        self.seats.iter().zip(moved).map(|(seat, by)| (seat.spring, seat.sign * by)).collect()
    }

    /// Why its joints found no equilibrium.
    pub fn failure(&self, error: JointsError) -> Failure {
        let JointsError::Open { seat, load } = error else { return error.into() };
        let name = self.seats.get(seat).map_or("", |own| self.joints[own.spring].as_str());
        let direction = self.seats.get(seat).map(|own| self.factored.structure().springs[own.spring].at.direction);
        let way = match direction {
            Some(Direction::X) => "x",
            Some(Direction::Turn) => "turning",
            _ => "y",
        };
        Failure {
            message: format!(
                "`structure.{name}` opens under a force of {}, and nothing else holds what it held",
                FORCE.format(load)
            ),
            help: format!(
                "raise its preload, or look whether it is pressed along its direction or against it: along = \"{way}\", \
                 \"-{way}\""
            ),
        }
    }

    /// Stiffness of the spring of a seat, N/m or N m/rad.
    pub fn stiffness(&self, seat: &DrawnSeat) -> f64 {
        self.factored.structure().springs[seat.spring].stiffness
    }
}

impl Draft {
    /// Number of a node of the model by its name.
    pub fn node(&self, name: &str) -> Option<usize> {
        self.nodes[..self.drawn].iter().position(|own| own.as_str() == name)
    }

    /// The pieces of some members, by their numbers in the structure.
    pub fn pieces(&self, members: &[Name]) -> Vec<usize> {
        let mut of: HashMap<&str, Vec<usize>> = HashMap::new();
        for (number, own) in self.members.iter().enumerate() {
            of.entry(own.as_str()).or_default().push(number);
        }
        members.iter().filter_map(|name| of.get(name.as_str())).flatten().copied().collect()
    }

    /// The stretches of x that some members reach along, m, with rising x.
    pub fn reach(&self, members: &[Name]) -> Vec<(f64, f64)> {
        let ends = |piece: usize| self.structure.members[piece].0.map(|node| self.structure.nodes[node][0]);
        let mut pieces: Vec<[f64; 2]> = self.pieces(members).into_iter().map(ends).collect();
        pieces.iter_mut().for_each(|x| x.sort_by(f64::total_cmp));
        pieces.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut reach: Vec<(f64, f64)> = Vec::new();
        for [low, high] in pieces {
            match reach.last_mut().filter(|last| low <= last.1 + NEAR) {
                Some(last) => last.1 = last.1.max(high),
                None => reach.push((low, high)),
            }
        }
        reach
    }

    /// How far some members reach along x, in words.
    pub fn reach_in_words(&self, members: &[Name]) -> String {
        let stretch = |(low, high): (f64, f64)| format!("from {} to {}", LENGTH.format(low), LENGTH.format(high));
        self.reach(members).into_iter().map(stretch).collect::<Vec<_>>().join(" and ")
    }

    /// The node at x (m) on what something stands on, which is put in where there is none; `None` beyond its ends.
    pub fn node_at(&mut self, stand: &Stand, x: f64) -> Option<usize> {
        let members = match stand {
            Stand::Node(node) => return Some(*node),
            Stand::Along(members) => members,
        };
        for piece in self.pieces(members) {
            let (ends, member) = self.structure.members[piece];
            let part = (x - self.structure.nodes[ends[0]][0]) / member.span[0];
            let near = NEAR / member.length();
            if part.abs() <= near {
                return Some(ends[0]);
            }
            if (part - 1.0).abs() <= near {
                return Some(ends[1]);
            }
            if (0.0..1.0).contains(&part) {
                return Some(self.split(piece, part));
            }
        }
        None
    }

    /// Puts a node into a member, at a part of its length.
    fn split(&mut self, piece: usize, part: f64) -> usize {
        let Structure { nodes, members, .. } = &mut self.structure;
        let ([a, b], member) = members[piece];
        let middle = nodes.len();
        nodes.push([0, 1].map(|k| nodes[a][k] + part * member.span[k]));
        members[piece] = ([a, middle], member.piece(part));
        members.push(([middle, b], member.piece(1.0 - part)));
        self.nodes.push(self.members[piece].clone());
        self.members.push(self.members[piece].clone());
        self.sizes.push(self.sizes[piece]);
        middle
    }

    /// Assembles and factors; what holds nothing is told at the table that is read.
    pub(super) fn factored(self, t: &Reader) -> Option<Drawn> {
        let Self { mut structure, nodes, members, sizes, joints, seats, .. } = self;
        // What is still sought has no value yet, and nothing is computed before it has: until then it is of a usual size.
        for spring in structure.springs.iter_mut().filter(|spring| spring.stiffness.is_nan()) {
            spring.stiffness = SOUGHT;
        }
        for (_, member) in &mut structure.members {
            let rigidities = [&mut member.axial_rigidity, &mut member.flexural_rigidity, &mut member.shear_rigidity];
            rigidities.into_iter().filter(|own| own.is_nan()).for_each(|own| *own = SOUGHT);
        }
        let places = structure.nodes.clone();
        let known = t.kept::<Cache<Topology, Plan, 2>>();
        let plan = known.get_or(structure.topology(), Plan::of);
        match plan.and_then(|plan| Factored::new(structure, plan)) {
            Ok(factored) => Some(Drawn { nodes, factored, members, sizes, joints, seats }),
            Err(StructureError::Loose { at, nodes: together }) => {
                let node = &nodes[at.node];
                let (moves, along) = match at.direction {
                    Direction::X => ("move along x", "x"),
                    Direction::Y => ("move along y", "y"),
                    Direction::Turn => ("turn", "turning"),
                };
                let [x, y] = places[at.node].map(|own| LENGTH.format(own));
                let message = match together {
                    1 => format!("nothing holds `{node}` at ({x}, {y}): it can {moves}"),
                    _ => format!(
                        "nothing holds `{node}` at ({x}, {y}) and {} nodes more: they can {moves}",
                        together - 1
                    ),
                };
                let help = format!(
                    "name a node in `clamped` or `pinned`, or add a joint, [structure.NAME] with at = \"{node}\", along = \
                     \"{along}\" and its stiffness"
                );
                t.problem("", message, help);
                None
            }
            Err(error) => {
                t.problem("", error.to_string(), "draw it with fewer nodes");
                None
            }
        }
    }
}

/// Stiffness of what is still sought, N/m.
const SOUGHT: f64 = 1e8;
/// Distance within which two places are one, m: sums of decimals are rounded.
pub const NEAR: f64 = 1e-9;
