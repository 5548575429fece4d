//! Writing results: for people, for programs, for ParaView. Each command has one [`Report`], and each
//! [`Format`] is a way to write it. Files appear whole or not at all.

mod budget;
mod chart;
mod columns;
mod comparison;
mod compensation;
mod csv;
mod diagnosis;
mod drawing;
mod error;
mod falling;
pub mod files;
mod fit;
mod folder;
mod json;
mod measurement;
mod measurements;
mod number;
mod page;
mod pictures;
mod plan;
mod plot;
mod plots;
mod report;
mod sketch;
pub mod study;
mod text;
pub mod vtk;

pub use budget::warnings as budget_warnings;
pub use columns::{columns, commented};
pub use compensation::{CONTROLS, Control, LINUXCNC, Supplied, supplied};
pub use diagnosis::additions;
pub use error::OutputError;
pub use folder::Folder;
pub use json::Json;
pub use measurements::measurements;
pub use page::{Evidence, Subject, page, trouble};
pub use pictures::{Pictures, figures, signatures};
pub use report::{Detail, Format, Report};
pub use text::Text;
