//! Solvers: the shaft under a travelling force, the joints that hold it, the plain sparse solve that checks
//! both, plane structures of beams and springs, a part laid on supports, heat in a rod from a tool that travels (`heat`) and from sources that
//! are switched (`rod`); a clamped circular plate (`diaphragm`); plane bodies: the sparse system, displacement, rings in jaws, temperature.

mod bar;
mod cholesky;
pub mod conduction;
pub mod diaphragm;
pub mod elastic;
mod equilibrium;
mod foundation;
pub mod frame;
pub mod heat;
pub mod laid;
mod plane;
pub mod ring;
pub mod rod;
mod seated;
mod selected;
mod shaft;
pub mod sparse;
pub mod structure;

pub use bar::Bar;
pub use equilibrium::{Equilibrium, JointsError, solve_joints};
pub use foundation::{Foundation, Moved, Seats};
pub use seated::{MOST_SEATS, Seated, System, resisted, solve_seated};
pub use shaft::{Condensed, Hold, Rest, Shaft, ShaftError};
