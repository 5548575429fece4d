//! Solvers: the shaft under a travelling force, the joints that hold it, and the plain sparse solve that checks both.

mod equilibrium;
pub mod frame;
pub mod heat;
mod plane;
mod shaft;

pub use equilibrium::{Equilibrium, JointsError, solve_joints};
pub use shaft::{Condensed, Hold, Rest, Shaft, ShaftError};
