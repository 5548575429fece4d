//! A ring pressed by jaws: loads on its outer circle at any angle, displacement of its bore at any angle; and
//! waves of load, of a plane ring by a single cell, of a tube that is pressed over a part of its length by its half section.

mod bore;
mod circle;
mod jaws;
mod tube;
mod wave;

pub use bore::{Bore, BoreShape};
pub use jaws::{ContactArc, JawCircle, add_jaws, add_jaws_on};
pub use tube::{Band, Tube};
pub use wave::{Cell, WaveRing};
