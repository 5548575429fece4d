//! Elements: what one piece of a body resists with.

mod bar;
mod beam;
mod member;
pub mod plane;
mod section;

pub use bar::BarPiece;
pub use beam::BeamPiece;
pub use member::{EndStiffness, Inside, Member};
pub use section::{Rectangle, Round, Tube};
