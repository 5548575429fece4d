//! Tests of one machine, each with a model of its own, as one model: what belongs to the machine is there once
//! and acts in every test that sees it. Everything that takes a model takes this one too.

mod data;
mod drawing;
mod effects;
mod forward;
mod join;
mod layout;
mod system;
mod test;

pub use effects::{Acting, Shared};
pub use test::{Campaign, Test};
