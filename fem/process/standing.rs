//! How what is made stands against what a drawing asks.

use super::{Characteristic, Requirement, Rows, System};

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
        // A million rows need not be looked at where nothing is asked.
        if all.is_empty() {
            return all;
        }
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
