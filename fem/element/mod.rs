//! Elements: what one piece of a body resists with.

mod bar;
mod beam;
pub mod plane;
mod section;

pub use bar::BarPiece;
pub use beam::BeamPiece;
pub use section::{Rectangle, Round};
