//! A ring pressed by jaws: loads on its outer circle at any angle, displacement of its bore at any angle; and
//! waves of load, by a single cell.

mod bore;
mod circle;
mod jaws;
mod wave;

pub use bore::{Bore, BoreShape};
pub use jaws::{ContactArc, JawCircle, add_jaws, add_jaws_on};
pub use wave::{Cell, WaveRing};
