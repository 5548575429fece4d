//! What a drawing asks of what is made.

use super::{Rows, System};
use crate::tolerance::Limits;
use crate::units::Kind;

/// One characteristic, and the limits that it has to keep.
#[derive(Clone, Debug, PartialEq)]
pub struct Requirement {
    /// Key for programs.
    pub key: &'static str,
    /// Name for people: "diameter of section 2, h6".
    pub label: String,
    /// Kind of its values.
    pub kind: Kind,
    /// Its limits, SI; those of a size are deviations from the nominal one.
    pub limits: Limits,
    /// The observable of which the limits hold in every row, by its position; `None` of a form, which several rows have together.
    pub of_rows: Option<usize>,
}

/// A characteristic of one part, as rows of it show it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Characteristic {
    /// Which of the requirements it is held against, by its position.
    pub requirement: usize,
    /// Number of the part, where parts have numbers.
    pub part: Option<usize>,
    /// The smallest and the largest value, SI; the same twice of a form.
    pub range: [f64; 2],
}

/// How parts stand against one requirement.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// What is asked.
    pub requirement: Requirement,
    /// The part, and the smallest and the largest value that rows of it show, SI.
    pub parts: Vec<(Option<usize>, [f64; 2])>,
}

impl Standing {
    /// How rows stand against all that a system has to keep, given the observable of every row, SI.
    pub fn all(system: &dyn System, rows: &Rows, values: &[f64]) -> Vec<Self> {
        let mut all: Vec<Self> =
            system.requirements().into_iter().map(|requirement| Self { requirement, parts: Vec::new() }).collect();
        for Characteristic { requirement, part, range } in system.characteristics(rows, values) {
            let parts = &mut all[requirement].parts;
            match parts.last_mut() {
                Some((own, known)) if *own == part => *known = [known[0].min(range[0]), known[1].max(range[1])],
                _ => parts.push((part, range)),
            }
        }
        all.retain(|standing| !standing.parts.is_empty());
        all
    }

    /// The parts that are out.
    pub fn out(&self) -> impl Iterator<Item = Option<usize>> {
        self.parts.iter().filter(|(_, range)| !self.requirement.limits.hold(*range)).map(|(part, _)| *part)
    }

    /// The smallest and the largest value of all parts.
    pub fn range(&self) -> [f64; 2] {
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        self.parts.iter().fold(start, |[low, high], (_, own)| [low.min(own[0]), high.max(own[1])])
    }
}
