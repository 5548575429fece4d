//! Processes: the ways in which the system makes or moves something, each a module of its own.
//!
//! A process is read from a model file into a [`System`]; a system with its effects acting is a [`Job`], which predicts.
//! To add a process, write its module and one line in [`ALL`].

pub mod axis;
pub mod cam;
pub mod contour;
mod drawing;
mod effect;
pub mod fixture;
mod grid;
mod observation;
mod outcome;
mod positioning;
pub mod ring;
mod segment;
pub mod stiffness;
pub mod thermal;
pub mod turning;
mod validation;
pub mod written;

pub use drawing::{Curve, Drawing, Spot};
pub use effect::{Active, Description, Effect, Neutral, Parameter, Values, act};
pub use grid::{Cell, Field, Frame, Grid};
pub use observation::{Absent, Blind, Coordinate, Further, Holds, Misplaced, Observable, Places, Rows};
pub use outcome::{Animation, Column, Finding, Outcome, Plot, Table};
pub use positioning::Positioning;
pub use segment::Segment;
pub use validation::{Case, Tolerance};
use validation::{row, set_up};
pub use written::{Meaning, WrittenLaw, equip};

use crate::input::Reader;
use crate::progress::Progress;

/// Every process the program knows.
pub const ALL: &[&dyn Process] = &[
    &turning::Turning,
    &ring::Ring,
    &thermal::Thermal,
    &fixture::Fixture,
    &stiffness::Stiffness,
    &axis::Axis,
    &contour::Contour,
    &cam::CamGrinding,
];

/// A way in which the system makes or moves something.
pub trait Process: Sync {
    /// The word after `process =`.
    fn name(&self) -> &'static str;

    /// What it predicts, in half a sentence.
    fn about(&self) -> &'static str;

    /// What can be measured of it. Observables of one dimension are two ways to tell the same, and a file has one of them; those of different
    /// dimensions may stand side by side.
    fn observables(&self) -> &'static [Observable];

    /// Under which coordinates and conditions it is measured.
    fn coordinates(&self) -> &'static [Coordinate];

    /// A commented model to start from.
    fn starting_model(&self) -> &'static str;

    /// Its catalogue of effects, in the order in which people meet them.
    fn effects(&self) -> Vec<&'static Description>;

    /// Reads its tables. What is wrong is noted in the reader; the system is of use only if nothing was.
    fn read(&self, model: &Reader) -> Box<dyn System>;

    /// Handbook and benchmark cases, computed.
    fn validation(&self) -> Vec<Case>;
}

/// A machine, fixture, tool and workpiece, ideal but for the workpiece's own elasticity.
pub trait System: Send + Sync {
    /// Says why an effect cannot act in this system, if it cannot.
    ///
    /// # Errors
    /// The reason, as a sentence.
    fn admits(&self, effect: &str) -> Result<(), String>;

    /// The rows that lie outside the system: off the body, beyond the programme.
    fn misplaced(&self, rows: &Rows) -> Vec<Misplaced>;

    /// The rows of its own programme, in the order in which a job predicts them, every coordinate resolved.
    fn programme(&self) -> Rows;

    /// The rows with every coordinate that they leave to the model filled in.
    fn resolved(&self, rows: &Rows) -> Rows;

    /// Where the rows lie on the body; `None` where the process has none to show.
    fn places(&self, rows: &Rows) -> Option<Places>;

    /// The contour that is made, in the plane of its places, where there is one to draw measured rows on. As a rule there is none.
    fn contour(&self) -> Option<Vec<Vec<Spot>>> {
        None
    }

    /// Directions to which the way of measuring these rows is blind. They are taken out of what was measured, as a job takes them out of
    /// what it predicts, and each costs a degree of freedom. As a rule there are none.
    fn blind(&self, _rows: &Rows) -> Vec<Blind> {
        Vec::new()
    }

    /// Where along a coordinate a cause may stand though no row is measured there: on the body, where its warmth is felt. As a rule what stands where nothing is
    /// measured cannot be seen.
    fn reach(&self, _coordinate: &str) -> Option<(f64, f64)> {
        None
    }

    /// What else could be measured beside these rows, for causes that they cannot tell apart.
    fn menu(&self, rows: &Rows) -> Vec<Further>;

    /// What the rows are as a positioning test, where they are one: then errors can be compensated.
    fn positioning(&self) -> Option<&dyn Positioning> {
        None
    }

    /// The system with effects acting, ready to predict.
    fn equip(&self, effects: &[Active]) -> Box<dyn Job>;
}

/// A system with its effects acting.
pub trait Job: Send + Sync {
    /// The observable at every point of the model's own programme, SI units.
    ///
    /// # Errors
    /// The computation failed: the body is loose, or an equilibrium was not found.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure>;

    /// What each row would show, in SI units of its observable.
    ///
    /// # Errors
    /// The computation failed.
    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure>;

    /// Everything a run reports, given the prediction and what each effect changes.
    ///
    /// # Errors
    /// The computation failed.
    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure>;
}

/// A computation that gave no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct Failure {
    /// What happened.
    pub message: String,
    /// What to change.
    pub help: String,
}
