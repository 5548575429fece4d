//! A shaft on its supports, condensed to its compliance at the tool and at the joints.
//!
//! The tool travels, so the profile is the *diagonal* of the compliance. The shaft is cut at every position;
//! the part on either side of a cut is one [`HalfPlane`], found for all cuts in one pass from each end. The
//! cost is that of pieces plus positions, and pieces of any length are exact. Headstock and tailstock stay
//! outside as rigid supports that the joints displace, so that nonlinear joints and the force's feedback are
//! a problem of two unknowns at each position (see `equilibrium`).

use super::foundation::{Foundation, Founded, Response};
use super::plane::{HalfPlane, Link, Turning};
use crate::element::BeamPiece;

/// A steady rest: a spring under the shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest {
    /// Distance from the headstock, m.
    pub at: f64,
    /// Stiffness, N/m.
    pub stiffness: f64,
    /// How far it stands out of the line of the shaft, m.
    pub offset: f64,
}

/// The hold of the headstock on the shaft's rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Hold {
    /// A centre: free to turn.
    Free,
    /// A chuck with this tilting compliance in rad/(N m); 0 is a clamp.
    Compliance(f64),
}

/// A shaft of uniform pieces from the headstock, held in translation there and, where there is a tailstock,
/// at its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaft {
    /// Pieces from the headstock on.
    pub pieces: Vec<BeamPiece>,
    /// Rotation at the headstock.
    pub hold: Hold,
    /// Whether a tailstock holds the far end.
    pub tailstock: bool,
    /// Springs between the ends.
    pub rests: Vec<Rest>,
}

/// The shaft cannot be condensed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShaftError {
    /// A rigid motion is left, or numbers have overflowed.
    #[error("the shaft is loose at x = {at} m: nothing holds it against the tool there")]
    Loose {
        /// Tool position, m.
        at: f64,
    },
    /// A position or a rest off the shaft.
    #[error("x = {at} m is not on the shaft, which is {length} m long")]
    OffTheShaft {
        /// Position, m.
        at: f64,
        /// Length of the shaft, m.
        length: f64,
    },
}

/// A shaft cut at a row of positions.
pub struct Condensed {
    /// Links from each cut to the next; the first cut is at the headstock, the last at the end.
    links: Vec<Link>,
    /// The side of each cut towards the headstock, with the rest at the cut.
    left: Vec<HalfPlane>,
    /// The side of each cut towards the tailstock, without the rest at the cut.
    right: Vec<HalfPlane>,
    /// The cut of each position.
    cuts: Vec<u32>,
    /// The cut of each rest.
    rests: Vec<u32>,
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
    founded: Option<Founded>,
}

impl Shaft {
    /// Length, m.
    pub fn length(&self) -> f64 {
        let mut length = RunningSum::default();
        self.pieces.iter().for_each(|p| length.add(p.length));
        length.value()
    }

    fn turning(&self) -> Turning {
        match self.hold {
            Hold::Free => Turning { p: 1.0, q: 0.0 },
            Hold::Compliance(p) => Turning { p, q: 1.0 },
        }
    }

    /// Whether statics alone gives the supports' forces.
    fn is_determinate(&self) -> bool {
        self.rests.is_empty() && !(self.tailstock && self.hold != Hold::Free)
    }

    /// Cuts the shaft at `positions` (m, in any order) and condenses it to them and to its two end supports.
    ///
    /// # Errors
    /// A position is off the shaft, or the shaft is loose.
    pub fn condense(&self, positions: &[f64]) -> Result<Condensed, ShaftError> {
        let Cuts { links, positions: cuts, rests } = self.cut(positions)?;
        let tail = if self.tailstock { HalfPlane::held(Turning::FREE) } else { HalfPlane::FREE };
        let ahead = || planes_ahead(HalfPlane::held(self.turning()), &links);
        let behind = || planes_behind(tail, &links);
        // Two threads pay from some ten thousand cuts on.
        let (left, right) = if links.len() > 8192 { rayon::join(ahead, behind) } else { (ahead(), behind()) };
        let compliance: Vec<f64> = cuts.iter().map(|&c| left[c as usize].joined(&right[c as usize]).0).collect();
        if let Some(i) = compliance.iter().position(|c| !c.is_finite()) {
            return Err(ShaftError::Loose { at: positions[i] });
        }
        let mut condensed = Condensed {
            links,
            left,
            right,
            bent: vec![0.0; cuts.len()],
            foundation_compliance: vec![0.0; cuts.len()],
            cuts,
            rests,
            compliance,
            influence: Vec::new(),
            constraint: [[0.0; 2]; 2],
            bent_forces: [0.0; 2],
            founded: None,
        };
        if self.is_determinate() {
            let length = self.length();
            let share = |x: &f64| if self.tailstock { [1.0 - x / length, x / length] } else { [1.0, 0.0] };
            condensed.influence = positions.iter().map(share).collect();
        } else {
            condensed.displace_supports(self);
        }
        Ok(condensed)
    }

    /// The same where supports and tool stand on what yields.
    ///
    /// # Errors
    /// As [`condense`](Self::condense).
    pub fn condense_on(&self, positions: &[f64], foundation: Foundation) -> Result<Condensed, ShaftError> {
        let mut condensed = self.condense(positions)?;
        let founded = Founded::new(foundation, condensed.response(self));
        for i in 0..positions.len() {
            (condensed.influence[i], condensed.foundation_compliance[i], condensed.bent[i]) = founded.at(i);
        }
        (condensed.constraint, condensed.bent_forces) = (founded.constraint(), founded.bent_forces());
        condensed.founded = Some(founded);
        Ok(condensed)
    }

    /// Splits the pieces at positions and rests.
    fn cut(&self, positions: &[f64]) -> Result<Cuts, ShaftError> {
        let length = self.length();
        let on_shaft = |at: f64| match (-1e-12 * length..=length * (1.0 + 1e-12)).contains(&at) {
            true => Ok(()),
            false => Err(ShaftError::OffTheShaft { at, length }),
        };
        positions.iter().copied().chain(self.rests.iter().map(|r| r.at)).try_for_each(on_shaft)?;
        let mut order: Vec<u32> = (0..(positions.len() + self.rests.len()) as u32).collect();
        let at =
            |i: u32| positions.get(i as usize).copied().unwrap_or_else(|| self.rests[i as usize - positions.len()].at);
        if !order.is_sorted_by(|a, b| at(*a) <= at(*b)) {
            order.sort_unstable_by(|a, b| at(*a).total_cmp(&at(*b)));
        }
        let mut cutter = Cutter::new(&self.pieces, self.pieces.len() + order.len(), length);
        let (mut cuts, mut rests) = (vec![0; positions.len()], vec![0; self.rests.len()]);
        for i in order {
            let cut = cutter.advance(at(i));
            match cuts.get_mut(i as usize) {
                Some(place) => *place = cut,
                None => {
                    let rest = i as usize - positions.len();
                    cutter.support(self.rests[rest].stiffness);
                    rests[rest] = cut;
                }
            }
        }
        cutter.advance(length);
        Ok(Cuts { links: cutter.links, positions: cuts, rests })
    }
}

/// Where a shaft is cut.
struct Cuts {
    /// From cut to cut.
    links: Vec<Link>,
    /// The cut of each position.
    positions: Vec<u32>,
    /// The cut of each rest.
    rests: Vec<u32>,
}

/// A sum that is rounded once and not at every step (Neumaier): the last of many short elements is short
/// against the position at which it stands.
#[derive(Clone, Copy, Default)]
struct RunningSum {
    sum: f64,
    carry: f64,
}

impl RunningSum {
    fn add(&mut self, term: f64) {
        let next = self.sum + term;
        self.carry += if self.sum.abs() >= term.abs() { (self.sum - next) + term } else { (term - next) + self.sum };
        self.sum = next;
    }

    fn value(self) -> f64 {
        self.sum + self.carry
    }
}

/// Walks along the pieces and makes links from cut to cut.
struct Cutter<'a> {
    pieces: std::iter::Peekable<std::slice::Iter<'a, BeamPiece>>,
    links: Vec<Link>,
    /// Place of the walk, and end of the current piece.
    here: f64,
    piece_end: RunningSum,
    /// Lengths below this are no length.
    nil: f64,
}

impl<'a> Cutter<'a> {
    fn new(pieces: &'a [BeamPiece], capacity: usize, length: f64) -> Self {
        let mut pieces = pieces.iter().peekable();
        let mut piece_end = RunningSum::default();
        piece_end.add(pieces.peek().map_or(0.0, |p| p.length));
        Self { pieces, links: Vec::with_capacity(capacity), here: 0.0, piece_end, nil: 1e-13 * length }
    }

    /// Walks to `to`, and gives the number of the cut there.
    fn advance(&mut self, to: f64) -> u32 {
        while let Some(piece) = self.pieces.peek().copied() {
            let piece_end = self.piece_end.value();
            let end = to.min(piece_end);
            if end - self.here > self.nil {
                self.links.push(BeamPiece { length: end - self.here, ..*piece }.into());
                self.here = end;
            }
            if to < piece_end + self.nil {
                break;
            }
            self.pieces.next();
            match self.pieces.peek() {
                Some(next) => self.piece_end.add(next.length),
                None => break,
            }
        }
        self.links.len() as u32
    }

    /// Puts a rest under the cut that was reached.
    fn support(&mut self, stiffness: f64) {
        if let Some(link) = self.links.last_mut() {
            link.rest += stiffness;
        }
    }
}

fn planes_ahead(start: HalfPlane, links: &[Link]) -> Vec<HalfPlane> {
    let mut planes = Vec::with_capacity(links.len() + 1);
    let mut plane = start;
    planes.push(plane);
    for link in links {
        plane = plane.beyond(link).with_rest(link);
        planes.push(plane);
    }
    planes
}

fn planes_behind(start: HalfPlane, links: &[Link]) -> Vec<HalfPlane> {
    let mut planes = vec![start; links.len() + 1];
    let mut plane = start;
    for (i, link) in links.iter().enumerate().rev() {
        plane = plane.with_rest(link).beyond(link);
        planes[i] = plane;
    }
    planes
}

impl Condensed {
    /// Finds influence and constraint by displacing headstock and tailstock by one unit each, and what rests out of
    /// line bend.
    fn displace_supports(&mut self, shaft: &Shaft) {
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
    fn response(&self, shaft: &Shaft) -> Response {
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

    /// Displacements of the supports with the tool's force (N) at position number `tool`, where joints have moved headstock
    /// and tailstock by `ends` (m): headstock, tailstock, the headstock's turning, the feet of the rests.
    pub fn supports_under(&self, tool: usize, force: f64, ends: [f64; 2]) -> Vec<f64> {
        match &self.founded {
            Some(founded) => founded.supports_under(tool, force, ends),
            None => [ends[0], ends[1], 0.0].into_iter().chain(self.rests.iter().map(|_| 0.0)).collect(),
        }
    }

    /// Forces (N) and the moment (N m) of the shaft on its supports, in the same order, where they stand on a foundation.
    pub fn reactions_under(&self, tool: usize, force: f64, ends: [f64; 2]) -> Option<Vec<f64>> {
        let supports = self.supports_under(tool, force, ends);
        self.founded.as_ref().map(|founded| founded.response.reactions(tool, force, &supports))
    }

    /// Forces of every steady rest (N), for the tool's force and displacements of the ends (m) at each of some first positions.
    pub fn rest_forces(&self, shaft: &Shaft, tools: &[(f64, [f64; 2])]) -> Vec<Vec<f64>> {
        let own = self.founded.is_none().then(|| self.response(shaft));
        let response = own.as_ref().or(self.founded.as_ref().map(|founded| &founded.response));
        let reactions = |(tool, (force, ends)): (usize, &(f64, [f64; 2]))| {
            let supports = self.supports_under(tool, *force, *ends);
            response.map_or_else(Vec::new, |own| own.reactions(tool, *force, &supports))
        };
        let all: Vec<Vec<f64>> = tools.iter().enumerate().map(reactions).collect();
        (3..3 + shaft.rests.len()).map(|rest| all.iter().map(|own| own[rest]).collect()).collect()
    }

    /// Deflection at every position (m) while the tool's force (N) stands at position number `tool`, where joints have moved
    /// headstock and tailstock by `ends` (m).
    pub fn line(&self, tool: usize, force: f64, ends: [f64; 2]) -> Vec<f64> {
        let unit = self.at_positions(&self.under_force_at(self.cuts[tool] as usize));
        let supports = self.supports_under(tool, force, ends);
        let moved = |i: usize| match &self.founded {
            Some(founded) => founded.response.moved(i, &supports),
            None => self.moved(i, ends),
        };
        unit.iter().enumerate().map(|(i, unit)| unit * force + moved(i)).collect()
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
