//! Steady and transient temperature of a plane body.
//!
//! ```text
//!   C Ṫ + K T = f(t),   K = conduction + convection,   T = g(t) on prescribed nodes
//! ```

mod conditions;
mod energy;
mod error;
mod history;
mod properties;
mod scheme;
mod steady;
mod surface;
mod system;
mod transient;
mod varying;

pub use conditions::{Condition, Loss};
pub use energy::Energy;
pub use error::ThermalError;
pub use history::{History, Power, Pulse, Swing};
pub use properties::{Potential, Properties};
pub use scheme::Scheme;
pub use surface::STEFAN_BOLTZMANN;
pub use system::ThermalSystem;
pub use transient::{Instant, Run};
