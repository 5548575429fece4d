//! A structure as it is drawn: its members bent, its joints to the ground.

use super::draft::Drawn;
use crate::element::Member;
use crate::process::{Body, Cell, Ends, Grid, Part, Role, Skin, SkinPoint};
use crate::solve::structure::{Direction, Displaced};
use crate::units::STIFFNESS;

/// Pieces into which a member is divided.
const PIECES: usize = 8;
/// Pieces of all members together: who draws a line in many members has divided it.
const ALL_PIECES: usize = 2000;

impl Drawn {
    /// Pieces into which each member is divided; a force within one stands between two.
    fn pieces(&self) -> usize {
        (ALL_PIECES / self.members.len().max(1)).clamp(2, PIECES)
    }

    /// Members with their height, and as they are bent; joints to the ground.
    pub fn sketch(&self, displaced: &Displaced) -> Vec<Part> {
        let structure = self.factored.structure();
        let outline = |(([a, b], member), [_, height]): (&([usize; 2], Member), &[f64; 2])| {
            let length = member.length();
            let across = [-member.span[1], member.span[0]].map(|own| 0.5 * height * own / length);
            let corner = |node: usize, side: f64| [0, 1].map(|k| structure.nodes[node][k] + side * across[k]);
            Part::Body(vec![vec![corner(*a, -1.0), corner(*b, -1.0), corner(*b, 1.0), corner(*a, 1.0)]])
        };
        let outlines = structure.members.iter().zip(&self.sizes).map(outline);
        let lines = (0..self.members.len()).map(|member| Part::Bent(displaced.line(member, self.pieces())));
        let springs = structure.springs.iter().zip(&self.joints).filter(|(spring, _)| spring.from.is_none());
        let held = springs.filter_map(|(spring, name)| {
            let (away, label) = match spring.at.direction {
                // Beside the machine there is no room for words.
                Direction::X => ([-1.0, 0.0], String::new()),
                Direction::Y => ([0.0, -1.0], format!("{name}, {:.0}", STIFFNESS.shown(spring.stiffness))),
                Direction::Turn => return None,
            };
            Some(Part::Spring { at: structure.nodes[spring.at.node], away, label })
        });
        outlines.chain(lines).chain(held).collect()
    }

    /// Puts the members into a grid as lines, and gives the displacement of every point that this adds, m.
    pub fn draw(&self, displaced: &Displaced, grid: &mut Grid) -> Vec<[f64; 3]> {
        let mut displacements = Vec::new();
        for member in 0..self.members.len() {
            let line = displaced.line(member, self.pieces());
            let first = grid.points.len() as u32;
            (first + 1..first + line.len() as u32).for_each(|i| grid.push(Cell::Line, &[i - 1, i]));
            grid.points.extend(line.iter().map(|([x, y], _)| [*x, *y, 0.0]));
            displacements.extend(line.iter().map(|(_, [u, v])| [*u, *v, 0.0]));
        }
        displacements
    }

    /// The members as bars with their width and height, on the points that [`draw`](Self::draw) has added from `first` on.
    pub fn bodies(&self, first: u32) -> Vec<Body> {
        let structure = self.factored.structure();
        let pieces = self.pieces();
        let bar = |(number, [width, height]): (usize, &[f64; 2])| {
            let span = structure.members[number].1.span;
            let length = span[0].hypot(span[1]);
            let across = [-span[1] / length, span[0] / length];
            let ring = |i: usize| {
                let node = Some(first + (number * (pieces + 1) + i) as u32);
                let corner = |(y, z): (f64, f64)| {
                    let [y, z] = [0.5 * y * height, 0.5 * z * width];
                    SkinPoint { node, offset: [y * across[0], y * across[1], z] }
                };
                [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(corner).to_vec()
            };
            let rings: Vec<Vec<SkinPoint>> = (0..=pieces).map(ring).collect();
            Body::new("structure", Role::Machine, Skin::lofted(&rings, Ends::Capped))
        };
        self.sizes.iter().enumerate().map(bar).collect()
    }
}
