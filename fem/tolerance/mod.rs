//! Limits that a drawing sets: tolerance classes of ISO 286-1, a deviation either way, or both limits.

mod iso286;
mod limits;
mod reading;

pub use limits::Limits;
