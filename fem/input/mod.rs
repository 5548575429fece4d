//! Reading what users write: where a text came from, what is wrong in it and where, and the reader by which every
//! table of a model file is read, checked and described at once.

mod field;
mod file;
mod pair;
mod problem;
mod reader;
mod several;
mod source;

pub use field::{Bounds, Choice, Count, Field};
pub use file::{FileKey, NamedFile, seen_from};
pub use problem::{InputError, Problem, did_you_mean, nearest};
pub use reader::{Found, Names, Parameter, Reader, Shape};
pub use source::Source;
