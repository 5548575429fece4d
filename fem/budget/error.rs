//! Errors as a budget file gives them.

use super::{Law, Stream, rules};

/// Way in which an error adds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The error is the same on every part, with its sign.
    Systematic,
    /// The error lies anywhere in its field.
    Random,
}

impl Kind {
    /// Words in a budget file.
    pub const WORDS: &[(&'static str, Self)] = &[("random", Self::Random), ("systematic", Self::Systematic)];

    /// Word in a budget file.
    pub fn word(self) -> &'static str {
        if self == Self::Random { "random" } else { "systematic" }
    }
}

/// Error of a budget.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// Name of the error.
    pub name: String,
    /// Way in which it adds.
    pub kind: Kind,
    /// Size, or half-field Δ, by the handbook, m.
    pub value: f64,
    /// Law in the handbook's rule.
    pub law: Law,
    /// Source of its size.
    pub source: Source,
    /// Group to which it belongs.
    pub group: Option<String>,
}

/// Source of the size of an error.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// The size is given.
    Given,
    /// The size comes from independent parts with half-fields, m: (44)–(46), (48).
    Parts(Vec<(Law, f64)>),
    /// The size comes from a contact y = c·Qⁿ under a clamping force: (47).
    Clamping {
        /// Compliances c_min and c_max, m/Nⁿ.
        c: (f64, f64),
        /// Clamping forces Q_min and Q_max, N.
        force: (f64, f64),
        /// Exponent n.
        exponent: f64,
    },
}

/// Group of errors that enter the total as one random error, the size of which is their own total.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Name by which errors refer to it.
    pub name: String,
    /// Law in the total.
    pub law: Law,
}

impl Contribution {
    /// Whether its sign is known too.
    pub fn has_sign(&self) -> bool {
        self.source == Source::Given
    }

    /// Number of draws that it takes.
    pub fn dimensions(&self) -> u32 {
        match (&self.kind, &self.source) {
            (Kind::Systematic, _) => 0,
            (_, Source::Given) => 1,
            (_, Source::Parts(parts)) => parts.len() as u32,
            (_, Source::Clamping { .. }) => 2,
        }
    }

    /// Draws the error on one part, m, with dimensions from `dimension` on.
    pub fn draw(&self, stream: &Stream, dimension: u32) -> f64 {
        if self.kind == Kind::Systematic {
            return self.value;
        }
        match &self.source {
            Source::Given => self.value * self.law.draw(stream, dimension, 0),
            Source::Parts(parts) => {
                let part = |(i, (law, half)): (u32, &(Law, f64))| half * law.draw(stream, dimension + i, 0);
                (0..).zip(parts).map(part).sum()
            }
            Source::Clamping { c, force, exponent } => {
                let within = |(low, high): (f64, f64), dimension: u32| {
                    let draw = Law::Normal.draw(stream, dimension, 0);
                    (0.5 * (low + high) + 0.5 * (high - low) * draw).max(0.0)
                };
                let sink = |c: f64, q: f64| c * q.powf(*exponent);
                let middle = |(low, high): (f64, f64)| 0.5 * (low + high);
                sink(within(*c, dimension), within(*force, dimension + 1)) - sink(middle(*c), middle(*force))
            }
        }
    }

    /// Half-field of independent parts, for a total of this law.
    pub fn of_parts(law: Law, parts: &[(Law, f64)]) -> f64 {
        rules::random(1.0 / law.lambda().sqrt(), parts)
    }
}
