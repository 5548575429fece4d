//! The displacement of an elastic body that is held, or free under loads in equilibrium.
//!
//! Vectors are over the freedoms 2 · node + axis (0 = x, 1 = y).

mod error;
mod loads;
mod stress;
mod supports;
mod system;

pub use error::{ElasticError, LooseMotion};
pub use loads::Loads;
pub use stress::nodal_stresses;
pub use supports::Prescribed;
pub use system::{Displacements, ElasticSystem};
