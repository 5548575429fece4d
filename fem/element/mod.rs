//! Elements: what one piece of a body resists with.

mod beam;
pub mod plane;
mod section;

pub use beam::BeamPiece;
pub use section::{Rectangle, Round};
