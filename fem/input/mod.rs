//! Reading what users write: where a text came from, what is wrong in it and where, and the reader by which
//! every table of a model file is read, checked and described at once.

mod bounds;
mod bytes;
mod cells;
mod damaged;
mod doubt;
mod excerpt;
mod field;
mod file;
mod kept;
mod line_ends;
mod listing;
mod name;
mod pair;
mod parameter;
mod problem;
mod raw;
mod reader;
mod record;
mod several;
mod source;
mod tables;
mod visible;
mod written;

pub use bounds::Bounds;
pub use bytes::{Stamp, read as bytes_of, stamp, text_of};
pub use cells::{line_at, name_and_unit, no_csv, number, parted_by_commas};
pub use damaged::{end_at_faults, unless_damaged};
pub use doubt::{Doubt, Grows};
pub use excerpt::{Excerpt, shortened};
pub use field::{Choice, Count, Field};
pub use file::{NamedFile, seen_from};
pub use kept::{Cache, Kept};
pub use line_ends::one_line;
pub use listing::{ListedRow, Listing};
pub use name::Name;
pub use parameter::{Parameter, ParameterId};
pub use problem::{InputError, Problem, did_you_mean, nearest};
pub use raw::{Raw, texts};
pub use reader::{FileKey, Found, Instead, Names, Reader, Shape, is_one_of, numbered};
pub use record::{Along, Record, Varying};
pub use source::{Source, stem};
pub use tables::read_tables;
pub use visible::{on_one_line, visible};
