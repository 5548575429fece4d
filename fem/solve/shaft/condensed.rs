//! A condensed shaft: what its supports, its line and its rests do under the tool.

use nalgebra::DMatrix;

use super::held::Shaft;
use crate::joint::Seat;
use crate::solve::foundation::{Founded, Moved, Response};
use crate::solve::plane::{HalfPlane, Link, Turning};

/// A shaft cut at a row of positions.
pub struct Condensed {
    /// Links from each cut to the next; the first cut is at the headstock, the last at the end.
    pub(super) links: Vec<Link>,
    /// The side of each cut towards the headstock, with the rest at the cut.
    pub(super) left: Vec<HalfPlane>,
    /// The side of each cut towards the tailstock, without the rest at the cut.
    pub(super) right: Vec<HalfPlane>,
    /// The cut of each position.
    pub(super) cuts: Vec<u32>,
    /// The cut of each rest.
    pub(super) rests: Vec<u32>,
    /// Deflection under the tool on rigid supports, m/N, per position.
    pub compliance: Vec<f64>,
    /// What the foundation adds to it, m/N, per position.
    pub foundation_compliance: Vec<f64>,
    /// Deflection at each position per unit displacement of headstock and tailstock; equally the part of the
    /// tool's force that each takes when both are rigid.
    pub influence: Vec<[f64; 2]>,
    /// Forces at headstock and tailstock per unit displacement of each, N/m: zero where statics alone
    /// decides.
    pub constraint: [[f64; 2]; 2],
    /// Deflection at each position by rests that stand out of line, on rigid supports, m.
    pub bent: Vec<f64>,
    /// Forces that they leave to headstock and tailstock, N.
    pub bent_forces: [f64; 2],
    /// What supports and tool stand on, if it yields: influence, constraint, bent and its forces are then those with it.
    pub(super) founded: Option<Founded>,
}

impl Condensed {
    /// Finds influence and constraint by displacing headstock and tailstock by one unit each, and what rests out of
    /// line bend.
    pub(super) fn displace_supports(&mut self, shaft: &Shaft) {
        let [(head, head_force), (tail, tail_force)] = self.ends_displaced(shaft);
        if shaft.tailstock {
            let mutual = self.on_rests(&head) - head_force;
            self.constraint = [[head_force, mutual], [mutual, tail_force]];
        } else {
            self.constraint[0][0] = head_force;
        }
        self.influence = self.cuts.iter().map(|&c| [head[c as usize], tail[c as usize]]).collect();
        let cuts = self.rests.clone();
        for (rest, &cut) in shaft.rests.iter().zip(&cuts).filter(|(rest, _)| rest.offset != 0.0) {
            // A spring whose foot is moved pushes with what would hold it there.
            let force = rest.stiffness * rest.offset;
            let unit = self.at_positions(&self.under_force_at(cut as usize));
            self.bent.iter_mut().zip(unit).for_each(|(w, unit)| *w += force * unit);
            for (force_there, at_rest) in self.bent_forces.iter_mut().zip([head[cut as usize], tail[cut as usize]]) {
                *force_there += force * at_rest;
            }
        }
    }

    /// Deflections at all cuts, and the force there (N/m), where headstock or tailstock is displaced by one unit.
    fn ends_displaced(&self, shaft: &Shaft) -> [(Vec<f64>, f64); 2] {
        let last = self.links.len();
        let (slope, head_force) = self.right[0].displaced(shaft.turning());
        let mut head = self.towards_tail(0, (1.0, slope));
        if !shaft.tailstock {
            return [(head, head_force), (vec![0.0; last + 1], 0.0)];
        }
        // Each is rigid while the other moves.
        head[last] = 0.0;
        let (slope, tail_force) = self.left[last].displaced(Turning::FREE);
        let mut tail = self.towards_head(last, (1.0, slope));
        tail[0] = 0.0;
        [(head, head_force), (tail, tail_force)]
    }

    /// Deflections at all cuts, and the force at the headstock and the moment there (N, N m), where what holds its rotation
    /// is turned by one unit, counter-clockwise.
    fn headstock_turned(&self, shaft: &Shaft) -> (Vec<f64>, [f64; 2]) {
        let turning = shaft.turning();
        let (mut line, turned) = match self.right[0].turned(turning) {
            Some((slope, force, moment)) => (self.towards_tail(0, (0.0, -slope)), [force, moment]),
            None => (vec![0.0; self.links.len() + 1], [0.0; 2]),
        };
        line[0] = 0.0;
        if shaft.tailstock {
            line[self.links.len()] = 0.0;
        }
        (line, turned)
    }

    /// Force of all rests together on a line, N: a support that makes it pushes the shaft against them.
    fn on_rests(&self, line: &[f64]) -> f64 {
        self.links.iter().zip(&line[1..]).map(|(link, w)| link.rest * w).sum()
    }

    /// How the shaft answers where its supports are moved: headstock, tailstock, the headstock's turning, the feet of
    /// the rests.
    pub(super) fn response(&self, shaft: &Shaft) -> Response {
        let [(head, head_force), (tail, tail_force)] = self.ends_displaced(shaft);
        let (turned, [turned_force, turned_moment]) = self.headstock_turned(shaft);
        let mut response = Response::new(3 + self.rests.len());
        // A foot that is moved leaves to the others what its spring pushes the shaft with.
        let feet: Vec<Vec<f64>> = (self.rests.iter().zip(&shaft.rests))
            .map(|(&cut, rest)| self.under_force_at(cut as usize).iter().map(|w| rest.stiffness * w).collect())
            .collect();
        response.set(0, 0, head_force);
        response.set(2, 0, turned_force);
        response.set(2, 2, turned_moment);
        if shaft.tailstock {
            response.set(1, 1, tail_force);
            response.set(0, 1, self.on_rests(&head) - head_force);
            response.set(1, 2, self.on_rests(&turned) - turned_force);
        }
        for (i, (foot, rest)) in feet.iter().zip(&shaft.rests).enumerate() {
            let own = self.rests[i] as usize;
            for (k, line) in [&head, &tail, &turned].into_iter().enumerate() {
                response.set(3 + i, k, -rest.stiffness * line[own]);
            }
            for (j, &other) in self.rests.iter().enumerate().take(i + 1) {
                let there = shaft.rests[j].stiffness * foot[other as usize];
                response.set(3 + i, 3 + j, if i == j { rest.stiffness - there } else { -there });
            }
        }
        let lines: Vec<&Vec<f64>> = [&head, &tail, &turned].into_iter().chain(&feet).collect();
        let at = |cut: u32| lines.iter().map(move |line| line[cut as usize]);
        response.influence = self.cuts.iter().flat_map(|cut| at(*cut)).collect();
        // Offsets are feet that are moved.
        for (i, rest) in shaft.rests.iter().enumerate() {
            response.move_support(3 + i, rest.offset);
        }
        response.bent.clone_from(&self.bent);
        response
    }

    /// Deflections at all cuts beyond `cut`, whose deflection and slope (counted toward the headstock) are
    /// `from`.
    fn towards_tail(&self, cut: usize, from: (f64, f64)) -> Vec<f64> {
        let mut deflections = vec![0.0; self.links.len() + 1];
        let mut end = from;
        deflections[cut] = end.0;
        for (i, link) in self.links.iter().enumerate().skip(cut) {
            end = self.right[i + 1].with_rest(link).followed(link, end);
            deflections[i + 1] = end.0;
        }
        deflections
    }

    /// Deflections at all cuts before `cut`, whose deflection and slope (counted toward the tailstock) are
    /// `from`.
    fn towards_head(&self, cut: usize, from: (f64, f64)) -> Vec<f64> {
        let mut deflections = vec![0.0; self.links.len() + 1];
        let mut end = from;
        deflections[cut] = end.0;
        for (i, link) in self.links.iter().enumerate().take(cut).rev() {
            end = self.left[i].followed(link, end);
            deflections[i] = end.0;
        }
        deflections
    }

    /// Deflection at position number `i` without a force, m: by rests out of line, and by headstock and tailstock that are
    /// moved (m).
    pub fn moved(&self, i: usize, ends: [f64; 2]) -> f64 {
        self.bent[i] + self.influence[i][0] * ends[0] + self.influence[i][1] * ends[1]
    }

    /// Joints of the foundation that are no springs.
    pub fn seats(&self) -> &[Seat] {
        self.founded.as_ref().map_or(&[], |founded| founded.seats())
    }

    /// Constraint of headstock, tailstock and the seats of the foundation, and the forces there without the tool; `None`
    /// without a foundation.
    pub fn whole(&self) -> Option<(&DMatrix<f64>, &[f64])> {
        self.founded.as_ref().map(Founded::whole)
    }

    /// Influence of headstock, tailstock and seats at position number `i`.
    pub fn whole_influence(&self, i: usize) -> Vec<f64> {
        self.founded.as_ref().map_or_else(|| self.influence[i].to_vec(), |founded| founded.whole_influence(i))
    }

    /// Displacements of the supports with the tool's force (N) at position number `tool`, and what joints have moved:
    /// headstock, tailstock, the headstock's turning, the feet of the rests.
    pub fn supports_under(&self, tool: usize, force: f64, moved: &Moved) -> Vec<f64> {
        match &self.founded {
            Some(founded) => founded.supports_under(tool, force, moved),
            None => [moved.ends[0], moved.ends[1], 0.0].into_iter().chain(self.rests.iter().map(|_| 0.0)).collect(),
        }
    }

    /// Forces (N) and the moment (N m) of the shaft on its supports, in the same order, where they stand on a foundation.
    pub fn reactions_under(&self, tool: usize, force: f64, moved: &Moved) -> Option<Vec<f64>> {
        let supports = self.supports_under(tool, force, moved);
        self.founded.as_ref().map(|founded| founded.response.reactions(tool, force, &supports))
    }

    /// Forces of every steady rest (N), for the tool's force and displacements of the ends (m) at each of some first positions.
    pub fn rest_forces(&self, shaft: &Shaft, tools: &[(f64, Moved)]) -> Vec<Vec<f64>> {
        let own = self.founded.is_none().then(|| self.response(shaft));
        let response = own.as_ref().or(self.founded.as_ref().map(|founded| &founded.response));
        let reactions = |(tool, (force, moved)): (usize, &(f64, Moved))| {
            let supports = self.supports_under(tool, *force, moved);
            response.map_or_else(Vec::new, |own| own.reactions(tool, *force, &supports))
        };
        let all: Vec<Vec<f64>> = tools.iter().enumerate().map(reactions).collect();
        (3..3 + shaft.rests.len()).map(|rest| all.iter().map(|own| own[rest]).collect()).collect()
    }

    /// Deflection at every position (m) while the tool's force (N) stands at position number `tool`, and what
    /// joints have moved.
    pub fn line(&self, tool: usize, force: f64, moved: &Moved) -> Vec<f64> {
        let unit = self.at_positions(&self.under_force_at(self.cuts[tool] as usize));
        let supports = self.supports_under(tool, force, moved);
        let at = |i: usize| match &self.founded {
            Some(founded) => founded.response.moved(i, &supports),
            None => self.moved(i, moved.ends),
        };
        unit.iter().enumerate().map(|(i, unit)| unit * force + at(i)).collect()
    }

    fn at_positions(&self, line: &[f64]) -> Vec<f64> {
        self.cuts.iter().map(|&cut| line[cut as usize]).collect()
    }

    /// Deflection at every cut under a unit force at one of them, on rigid supports; m/N.
    fn under_force_at(&self, cut: usize) -> Vec<f64> {
        let (w, slope) = self.left[cut].joined(&self.right[cut]);
        let (mut line, after) = (self.towards_head(cut, (w, slope)), self.towards_tail(cut, (w, -slope)));
        line[cut..].copy_from_slice(&after[cut..]);
        line
    }
}
