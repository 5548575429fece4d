//! The frame of a process: what its author writes, and what the layers above see.
//!
//! The author of a process writes a [`Definition`] with types of its own; one adapter makes of it the
//! object-safe [`Process`], [`System`] and [`ForwardModel`] that the layers above use.

mod adapter;
mod advice;
mod allowed;
mod belongs;
mod bench;
mod blank;
mod change;
mod command;
mod controller;
mod definition;
mod drawing;
mod effect;
pub mod estimates;
mod failure;
mod figure;
pub mod formula_effect;
mod gauged;
mod grid;
mod interface;
mod making;
mod nut;
mod observation;
mod polyline;
mod positioning;
mod report;
mod requirement;
mod scene;
mod segment;
mod sketch;
mod standing;
pub(crate) mod structure;
mod tested;
mod values;
mod winding;
mod words;

pub use adapter::Assembled;
pub use advice::Advice;
pub use allowed::{Allowed, AllowedWords};
pub use belongs::{Belongs, UnitRole};
pub(crate) use bench::assembled;
#[cfg(test)]
pub(crate) use bench::{with_effect, with_effects};
pub(crate) use blank::{BlankProfile, BlankWords, Wave};
pub use change::{CHANGED, change_of, is_size, name_of_change};
pub use command::{Answers, Command, Commanded, RADIUS_CHANGE, order};
pub use controller::Controller;
pub use definition::{Contradiction, Definition, Forward, Limit, Variant};
pub use drawing::{Curve, Drawing, Spot, round_below};
pub use effect::{Active, CatalogueEffect, Description, EFFECTS, Effect, Neutral, ON_TRIAL, Odds, Parameter, nothing};
pub use failure::Failure;
pub use figure::{Datum, Figure, extremes, first_extreme, range, spread};
pub use formula_effect::{FormulaLaw, Meaning};
pub use gauged::Gauged;
pub use grid::{Cell, Field, Grid};
pub use interface::{ForwardModel, Process, System};
pub use making::{Making, NoLaw};
pub use nut::Nut;
pub use observation::{
    Absent, CandidateExperiment, Coordinate, DatumDirection, Holds, Misplaced, Observable, Places, Rows,
};
pub use polyline::on_lines;
pub use positioning::{Positioning, ROUNDED, finer};
pub use report::{Animation, Column, Plot, RunReport, Table};
pub use requirement::{Characteristic, Requirement};
pub use scene::{Arrow, Body, Ends, Frame, Role, Skin, SkinPoint, View};
pub use segment::Segment;
pub use sketch::{Part, Sketch};
pub use standing::Standing;
pub use tested::Tested;
pub use values::Values;
pub use winding::Winding;
pub use words::Words;
