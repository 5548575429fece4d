//! Lengths of a round body with surroundings of their own: another room, a coolant around it, steam through its bore.

use super::body::Body;
use super::boundary::{Boundary, temperature};
use super::revolved;
use crate::input::{Along, Reader};
use crate::mesh::{BORE, OUTSIDE};
use crate::process::estimates;
use crate::solve::rod::History;
use crate::units::{CONVECTION, LENGTH};

/// The surface of a round body that surroundings touch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The round surface.
    Outside,
    /// The bore.
    Bore,
}

/// A length of a rod or of a body of revolution with surroundings of its own.
#[derive(Clone, Debug)]
pub struct Surroundings {
    /// Where it begins and ends, m from the base.
    pub ends: [f64; 2],
    /// The surface that they touch.
    pub side: Side,
    /// Their temperature over time, K.
    pub temperature: History,
    /// Film coefficient, W/(m² K); that of all free surfaces where it is not said.
    pub coefficient: Option<f64>,
}

impl Side {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] = &[("outside", Self::Outside), ("bore", Self::Bore)];

    /// The edge of a body of revolution that it is.
    pub fn edge(self) -> &'static str {
        match self {
            Self::Outside => OUTSIDE,
            Self::Bore => BORE,
        }
    }
}

impl Surroundings {
    /// Reads an entry of `[[environment.section]]`; a record of its temperature must reach over the `run`.
    pub fn read(t: &Reader, body: &Body, run: Along) -> Self {
        let length = body.length();
        let from = t.quantity("from", LENGTH, "where it begins, from the base; there if left out").not_negative();
        let from = from.or(0.0);
        let to = t.quantity("to", LENGTH, "where it ends; at the free end if left out").or(length);
        let side = t.choice("side", "the surface that they touch", Side::WORDS).or_first(Side::Outside);
        let own = temperature(t, "temperature", "of what is around it there", run);
        if own.is_none() && !t.is_described() {
            let example = "add temperature = \"12 degC\"";
            t.problem("temperature", "the temperature of these surroundings is not said", example);
        }
        let about = "film coefficient of the loss to them; that of `convection` if left out";
        let coefficient = t.quantity("coefficient", CONVECTION, about).estimated(estimates::FILM).not_negative();
        let coefficient = coefficient.optional();
        let all = Self { ends: [from, to], side, temperature: own.unwrap_or(History::Constant(0.0)), coefficient };
        if !t.is_described() {
            all.check(t, body);
        }
        all
    }

    fn check(&self, t: &Reader, body: &Body) {
        let ([from, to], length) = (self.ends, body.length());
        let segments = if let Body::Rod(segments) = body { Some(&segments[..]) } else { body.revolved() };
        let Some(segments) = segments else {
            let help = "an edge of a plane body has surroundings of its own by [[boundary]] convection and ambient";
            t.problem("", "a plane body has no lengths with surroundings of their own", help);
            return;
        };
        if to <= from {
            t.problem("to", "the section ends where it begins, or before", "give it a length");
        }
        if to > length * (1.0 + 1e-9) {
            let message = format!("{} is not on the body", LENGTH.format(to));
            t.problem("to", message, format!("it reaches from 0 to {}", LENGTH.format(length)));
        }
        if self.side == Side::Outside {
            return;
        }
        if self.coefficient.is_none() {
            let help =
                "add coefficient = \"500 W/m^2/K\"; water takes some hundreds to thousands, steam that condenses more";
            t.problem("coefficient", "the film in a bore is not that of the free surface", help);
        }
        if let Some(solid) = revolved::solid(segments, [from, to]) {
            let message = format!("a segment of {} there has no bore", LENGTH.format(solid));
            t.problem("side", message, "give the segment a `bore`, or end the section before it");
        }
    }

    /// Whether they touch the same surface somewhere.
    fn overlaps(&self, other: &Self) -> bool {
        let [from, to] = [self.ends[0].max(other.ends[0]), self.ends[1].min(other.ends[1])];
        self.side == other.side && from < to * (1.0 - 1e-9)
    }
}

/// Refuses surroundings of a surface that has a film or a temperature of its own, or is covered.
pub fn refuse_taken(model: &Reader, all: &[Surroundings], boundaries: &[Boundary]) {
    let taken = all.iter().find_map(|s| boundaries.iter().find(|b| !b.is_open() && b.edge == s.side.edge()));
    if let Some(Boundary { edge, .. }) = taken {
        let message = format!("edge `{edge}` has a condition of its own, and a section of the environment around it");
        model.problem("boundary", message, "keep one of them");
    }
}

/// Refuses two surroundings of one surface.
pub fn refuse_overlaps(t: &Reader, all: &[Surroundings]) {
    let pair = (0..all.len()).find_map(|i| (0..i).find(|j| all[i].overlaps(&all[*j])).map(|j| (j, i)));
    if let Some((one, other)) = pair {
        let message = format!("sections {} and {} are around the same length", one + 1, other + 1);
        t.problem("section", message, "end one where the other begins");
    }
}
