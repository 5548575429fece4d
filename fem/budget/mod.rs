//! Budgets: errors added up by the handbook's rules and, beside them, by Monte Carlo of the same inputs through the laws and models themselves.
//!
//! Systematic errors add with their signs [seed 002 (40)], random ones as the root of weighted squares [(42)], the two arithmetically. The rule is made for
//! pencil and paper: it takes every law for linear, and the sum for normal. Drawing the inputs shows where it is too pessimistic.

mod drill;
mod error;
mod estimate;
mod law;
mod monte_carlo;
mod part;
mod random;
mod read;
pub mod rules;
mod validation;

pub use drill::{Drill, Unknown};
pub use error::{Contribution, Group, Kind, Source};
pub use estimate::{Estimate, Handbook, Share, estimate};
pub use law::Law;
pub use monte_carlo::{Drawn, Measured, Rejects};
pub use part::{Input, ModelPart, Target};
pub use random::Stream;
pub use read::load;
pub use validation::cases as validation;

use crate::input::Source as File;

/// A budget to begin with, commented.
pub const STARTING: &str = include_str!("new.toml");

/// What a budget file says. Lengths in m.
pub struct Budget {
    /// The file.
    pub file: File,
    /// `title`, if it has one.
    pub title: Option<String>,
    /// t of (42): 1, 2, 3 for a risk of 32, 4.5, 0.27 %.
    pub t: f64,
    /// Least and largest total that is accepted, m.
    pub tolerance: Option<(f64, f64)>,
    /// Draws of the Monte Carlo.
    pub samples: usize,
    /// What the draws begin from.
    pub seed: u64,
    /// The errors that are given, in the order of the file.
    pub errors: Vec<Contribution>,
    /// Sets of errors that enter the total as one.
    pub groups: Vec<Group>,
    /// What a model contributes.
    pub model: Option<ModelPart>,
    /// A hole made by a tool of its size.
    pub drill: Option<Drill>,
}

impl Budget {
    /// 2·(1 − Φ(t)): the part of a normal law beyond ±t standard deviations.
    pub fn risk(&self) -> f64 {
        statrs::function::erf::erfc(self.t / std::f64::consts::SQRT_2)
    }
}
