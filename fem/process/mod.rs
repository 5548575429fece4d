//! Processes: the ways in which the system makes or moves something, each a module of its own.
//!
//! The author of a process writes a [`Definition`] with types of its own; one adapter makes of it the
//! object-safe [`Process`], [`System`] and [`ForwardModel`] that the layers above use. To add a process,
//! write its module and one line in [`ALL`].

mod adapter;
pub mod axis;
mod belongs;
mod blank;
pub mod cam;
mod cases;
pub mod contour;
mod definition;
mod drawing;
mod effect;
mod failure;
mod figure;
pub mod fixture;
pub mod formula_effect;
mod grid;
mod interface;
mod nut;
mod observation;
mod positioning;
mod registry;
mod report;
pub mod ring;
mod scene;
mod segment;
mod sketch;
pub mod stiffness;
pub mod thermal;
pub mod turning;
mod values;
mod winding;

pub use adapter::Assembled;
pub use belongs::{Belongs, UnitRole};
use blank::{BlankProfile, BlankWords, Wave};
#[cfg(test)]
use cases::with_effect;
pub use cases::{Case, Tolerance};
use cases::{assembled, bisect, figure as figure_of, row};
pub use definition::{Contradiction, Definition, Forward, Limit};
pub use drawing::{Curve, Drawing, Spot, round_below};
pub use effect::{Active, CatalogueEffect, Description, EFFECTS, Effect, Neutral, Parameter, nothing};
pub use failure::Failure;
pub use figure::{Datum, Figure, extremes, first_extreme, range, spread};
pub use formula_effect::{FormulaLaw, Meaning};
pub use grid::{Cell, Field, Grid};
pub use interface::{ForwardModel, Process, System};
pub use nut::Nut;
pub use observation::{
    Absent, CandidateExperiment, Coordinate, DatumDirection, Holds, Misplaced, Observable, Places, Rows,
};
pub use positioning::Positioning;
pub use registry::{ALL, validation};
pub use report::{Animation, Column, Plot, RunReport, Table};
pub use scene::{Arrow, Body, Ends, Frame, Role, Skin, SkinPoint, View};
pub use segment::Segment;
pub use sketch::{Part, Sketch};
pub use values::Values;
pub use winding::Winding;
