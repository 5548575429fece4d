//! Cam: a plane cam ground by a polar grinder, the slide with the wheel against the turning cam, block by block [seed 003].
//!
//! Within a block cam and slide go linearly, and the wheel's centre runs an arc of an Archimedean spiral instead of the curve at the wheel's radius from the profile. The
//! envelope of the wheel then leaves material (+) or cuts too deep (−). `deviation` is measured along the normal of the profile, over the polar angle of the
//! profile's point, counter-clockwise from +x. The wheel goes along the profile in the order in which it is drawn.

mod contact;
mod effects;
mod extreme;
mod fewest;
mod findings;
mod job;
mod machine;
mod model;
mod motion;
mod observe;
mod profile;
mod program;
mod report;
mod shapes;
mod tables;
mod validation;
mod warnings;

pub use job::Cam;
pub use machine::{Machine, Pass};
pub use model::{By, Division, Pace, Setup};

use std::sync::Arc;

use super::{
    Active, Case, Coordinate, Description, Effect, Failure, Further, Job, Misplaced, Observable, Outcome, Places,
    Process, Rows, Spot, System,
};
use crate::input::Reader;
use crate::progress::Progress;

/// The process `cam`.
pub struct CamGrinding;

impl Process for CamGrinding {
    fn name(&self) -> &'static str {
        "cam"
    }

    fn about(&self) -> &'static str {
        "deviation of a cam that a polar grinder interpolates linearly"
    }

    fn observables(&self) -> &'static [Observable] {
        observe::OBSERVABLES
    }

    fn coordinates(&self) -> &'static [Coordinate] {
        observe::COORDINATES
    }

    fn starting_model(&self) -> &'static str {
        include_str!("new.toml")
    }

    fn effects(&self) -> Vec<&'static Description> {
        effects::ALL.iter().map(|e| e.description()).collect()
    }

    fn read(&self, model: &Reader) -> Box<dyn System> {
        match Setup::read(model) {
            Some(setup) => Box::new(Grinder(Arc::new(setup))),
            None => Box::new(NoGrinder),
        }
    }

    fn validation(&self) -> Vec<Case> {
        validation::cases()
    }
}

/// A grinder with its programme, before any effect acts.
struct Grinder(Arc<Setup>);

impl System for Grinder {
    fn admits(&self, effect: &str) -> Result<(), String> {
        self.0.admits(effect)
    }

    fn misplaced(&self, rows: &Rows) -> Vec<Misplaced> {
        observe::misplaced(rows)
    }

    fn programme(&self) -> Rows {
        observe::programme(&self.0)
    }

    fn resolved(&self, rows: &Rows) -> Rows {
        observe::resolved(&self.0, rows)
    }

    fn places(&self, rows: &Rows) -> Option<Places> {
        Some(observe::places(&self.0, rows))
    }

    fn contour(&self) -> Option<Vec<Vec<Spot>>> {
        Some(vec![shapes::spots(&self.0, |_| 0.0)])
    }

    fn menu(&self, _rows: &Rows) -> Vec<Further> {
        observe::menu(&self.0)
    }

    fn equip(&self, active: &[Active]) -> Box<dyn Job> {
        Box::new(Cam::equip(self.0.clone(), active))
    }
}

/// What stands for a grinder where the model file has none that could be read.
struct NoGrinder;

impl System for NoGrinder {
    fn admits(&self, _effect: &str) -> Result<(), String> {
        Ok(())
    }

    fn misplaced(&self, _rows: &Rows) -> Vec<Misplaced> {
        Vec::new()
    }

    fn programme(&self) -> Rows {
        Rows::default()
    }

    fn resolved(&self, rows: &Rows) -> Rows {
        rows.clone()
    }

    fn places(&self, _rows: &Rows) -> Option<Places> {
        None
    }

    fn menu(&self, _rows: &Rows) -> Vec<Further> {
        Vec::new()
    }

    fn equip(&self, _active: &[Active]) -> Box<dyn Job> {
        Box::new(Self)
    }
}

impl NoGrinder {
    fn failure() -> Failure {
        Failure { message: "there is no cam to grind".into(), help: "mend the model file".into() }
    }
}

impl Job for NoGrinder {
    fn predict(&self, _progress: &Progress) -> Result<Vec<f64>, Failure> {
        Err(Self::failure())
    }

    fn observe(&self, _rows: &Rows) -> Result<Vec<f64>, Failure> {
        Err(Self::failure())
    }

    fn outcome(&self, _prediction: Vec<f64>) -> Result<Outcome, Failure> {
        Err(Self::failure())
    }
}

/// The effects that this process knows, by name.
fn effect(name: &str) -> Option<&'static dyn Effect<Machine>> {
    effects::ALL.iter().copied().find(|e| e.description().name == name)
}
