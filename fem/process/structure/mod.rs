//! The machine under a part as a plane structure: nodes, members and joints with names of the user's choice, and the
//! places on it where a process stands.
//!
//! Every process reads the same table `[structure]` and says which ports it needs; what it makes of their compliance is
//! its own business.

mod draft;
mod drawing;
mod places;
mod read;
mod shares;

pub use draft::{Draft, Drawn, NEAR, Port, Stand};
pub use places::{Place, Places, Pushed};
pub use shares::Shares;
