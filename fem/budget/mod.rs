//! Adds errors up in budgets: by the handbook's rules and, beside them, by Monte Carlo of the same inputs
//! through the laws and models themselves.
//!
//! Systematic errors add with their signs [seed 002 (40)], random errors as the root of weighted squares
//! [(42)], the two sums arithmetically. The rule is made for pencil and paper: it takes every law for
//! linear, and the sum for normal. Monte Carlo shows where it is too pessimistic.

mod drill;
mod error;
mod estimate;
mod law;
mod monte_carlo;
mod part;
mod purchase;
mod random;
mod read;
pub mod rules;
mod sizes;

pub use drill::{Drill, Unknown};
pub use error::{Contribution, Group, Kind, Source};
pub use estimate::{Estimate, Handbook, Share};
pub use law::Law;
pub use monte_carlo::{Drawn, Measured, Rejects};
pub use part::{Figure, Input, ModelPart, Models, Target};
pub use purchase::Purchase;
pub use random::Stream;

use crate::input::Source as File;

/// Commented budget to begin with.
pub const STARTING: &str = include_str!("new.toml");

/// Budget file. Lengths in m.
#[non_exhaustive]
pub struct Budget {
    /// Name and text of the file.
    pub file: File,
    /// The key `title`, if the file has it.
    pub title: Option<String>,
    /// Coefficient t of (42): 1, 2, 3 for a risk of 32, 4.5, 0.27 %.
    pub t: f64,
    /// Smallest and largest total that is accepted, m.
    pub tolerance: Option<(f64, f64)>,
    /// Number of samples of the Monte Carlo.
    pub samples: usize,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Errors, in the order of the file.
    pub errors: Vec<Contribution>,
    /// Groups of errors that enter the total as one.
    #[doc(hidden)]
    pub groups: Vec<Group>,
    /// Figures of models with inputs that vary.
    #[doc(hidden)]
    pub models: Models,
    /// Hole made by a tool of its size, if there is one.
    #[doc(hidden)]
    pub drill: Option<Drill>,
}

impl Budget {
    /// Risk 2·(1 − Φ(t)): the part of a normal distribution beyond ±t standard deviations.
    pub fn risk(&self) -> f64 {
        statrs::function::erf::erfc(self.t / std::f64::consts::SQRT_2)
    }
}
