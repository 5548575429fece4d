//! Studies: many jobs with one model. A plan says what varies, over a grid, drawn or by a table; each job runs, fits
//! or diagnoses the model at one point, and is a row of results. What the rows say of yield, worst case and sensitivity
//! is summed up while they are read.
//!
//! A job depends on its number alone, and rows are handed on in the order of the numbers: so they are the same on any
//! number of threads, however often a study was interrupted, and in however many shards it was done.

mod acceptance;
pub(crate) mod design;
mod in_order;
pub(crate) mod indices;
mod job;
mod layout;
mod plan;
mod quantity;
mod read;
mod shuffle;
mod sobol;
mod summary;
mod table;
mod wildcard;

pub use acceptance::Acceptance;
pub use design::{Design, Input, Points, Sampler, Spread};
pub use in_order::in_order;
pub use indices::{Index, Indices};
pub use layout::{Layout, Nature, ResultColumn, Shard};
pub use plan::{Offered, StudyPlan, Task, Wanted};
pub(crate) use quantity::no_quantity;
pub use read::schema;
pub use summary::{Cell, Extreme, Found, Numbers, Row, Summary, Summing};

/// Commented plan to begin with.
pub const STARTING: &str = include_str!("new.toml");
