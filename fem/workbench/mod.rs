//! The workbench: compare, see where it fails, learn what is missing, add it, and correct, on a page in a browser of this computer.
//! A face on what can be asked (`ask`): it computes nothing itself and says nothing that the commands would not say.
//!
//! A [`Session`] holds what is open and what was done, and answers plain questions; `server` hands them from the page to it.

mod assets;
mod bench;
mod disk;
mod edits;
mod export;
mod folder;
mod gate;
mod job;
mod kept;
mod look;
mod measured;
mod refusal;
mod resume;
mod runs;
mod server;
mod session;
mod steps;
mod told;
mod trial;

pub use gate::{Gate, guarded};
pub use server::serve;
pub use session::Session;
