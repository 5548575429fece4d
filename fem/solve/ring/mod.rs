//! A ring pressed by jaws: loads on its outer circle at any angle, displacement of its bore at any angle.

mod bore;
mod circle;
mod jaws;

pub use bore::{Bore, BoreShape};
pub use jaws::{ContactArc, add_jaws, add_radial};
