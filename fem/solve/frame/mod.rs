//! The plain finite-element solve of a shaft: assemble, factor, solve, check. It is the independent check of
//! the fast sweep, shares nothing with it but the beam's rigidities, and its only refinement is that the
//! balance of forces is evaluated in twofold precision.

mod builder;
mod error;
mod joint_state;
mod linear;
mod newton;
mod solution;
mod support;
mod system;

pub use builder::Frame;
pub use error::{FrameError, SolveError};
pub use linear::FactoredFrame;
pub use solution::{Convergence, Reaction, Solution};
pub use support::{LooseMotion, SupportKind};
