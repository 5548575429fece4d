//! A study: its rows as they grow, and what they say.

mod folder;
mod json;
mod layout;
mod merge;
mod rows;
mod text;

pub use folder::{Earlier, StudyError, StudyFolder};
pub use json::json;
pub use merge::merge;
pub use rows::line;
pub use text::text;
