//! Errors as a budget file gives them.

use super::{Law, Stream, rules};

/// How an error adds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The same on every part, with its sign.
    Systematic,
    /// Anywhere in its field.
    Random,
}

impl Kind {
    /// The words of a budget file.
    pub const WORDS: &[(&'static str, Self)] = &[("random", Self::Random), ("systematic", Self::Systematic)];

    /// Its word.
    pub fn word(self) -> &'static str {
        if self == Self::Random { "random" } else { "systematic" }
    }
}

/// An error of a budget.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// What it is.
    pub name: String,
    /// How it adds.
    pub kind: Kind,
    /// Its size, or its half-field Δ, by the handbook, m.
    pub value: f64,
    /// Its law in the handbook's rule.
    pub law: Law,
    /// What it comes from.
    pub source: Source,
    /// The set it belongs to.
    pub group: Option<String>,
}

/// What the size of an error comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// It is given.
    Given,
    /// From independent parts with half-fields, m: (44)–(46), (48).
    Parts(Vec<(Law, f64)>),
    /// From a contact y = c·Qⁿ under a clamping force: (47).
    Clamping {
        /// c_min, c_max, m/Nⁿ.
        c: (f64, f64),
        /// Q_min, Q_max, N.
        force: (f64, f64),
        /// n.
        exponent: f64,
    },
}

/// Errors that enter the total as one random error, the size of which is their own total.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// By which errors name it.
    pub name: String,
    /// Its law in the total.
    pub law: Law,
}

impl Contribution {
    /// Whether more than its size is known.
    pub fn has_sign(&self) -> bool {
        self.source == Source::Given
    }

    /// How many draws it takes.
    pub fn dimensions(&self) -> u32 {
        match (&self.kind, &self.source) {
            (Kind::Systematic, _) => 0,
            (_, Source::Given) => 1,
            (_, Source::Parts(parts)) => parts.len() as u32,
            (_, Source::Clamping { .. }) => 2,
        }
    }

    /// What it is on one part, m; draws from `dimension` on.
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

    /// A random error of the given half-field.
    pub fn given(name: impl Into<String>, kind: Kind, law: Law, value: f64) -> Self {
        Self { name: name.into(), kind, value, law, source: Source::Given, group: None }
    }

    /// The half-field of independent parts, for a total of this law.
    pub fn of_parts(law: Law, parts: &[(Law, f64)]) -> f64 {
        rules::random(1.0 / law.lambda().sqrt(), parts)
    }
}
