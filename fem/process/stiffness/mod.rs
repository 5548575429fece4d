//! Stiffness: a joint or a whole machine is pushed up to a force and let go again, and gives way by y(F).
//!
//! The ideal one is a spring, y = F/k. Clearance, contact, friction and preload bend its curve, and where loading and unloading part, the area between
//! them is the work of friction [seed 000, fig. 5].

mod curve;
mod effects;
mod findings;
mod job;
mod model;
mod observe;
mod validation;

pub use curve::{Branch, Curve};
pub use job::Pushed;
pub use model::Setup;

use std::sync::Arc;

use super::{
    Active, Case, Coordinate, Description, Effect, Further, Job, Misplaced, Observable, Places, Process, Rows, System,
};
use crate::input::Reader;

/// The process `stiffness`.
pub struct Stiffness;

impl Process for Stiffness {
    fn name(&self) -> &'static str {
        "stiffness"
    }

    fn about(&self) -> &'static str {
        "displacement of a joint that is loaded and unloaded"
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
        Box::new(Bench(Arc::new(Setup::read(model))))
    }

    fn validation(&self) -> Vec<Case> {
        validation::cases()
    }
}

/// A joint and its test, before any effect acts.
struct Bench(Arc<Setup>);

impl System for Bench {
    fn admits(&self, _effect: &str) -> Result<(), String> {
        Ok(())
    }

    fn misplaced(&self, rows: &Rows) -> Vec<Misplaced> {
        observe::misplaced(&self.0, rows)
    }

    fn programme(&self) -> Rows {
        observe::programme(&self.0)
    }

    fn resolved(&self, rows: &Rows) -> Rows {
        rows.clone()
    }

    fn places(&self, _rows: &Rows) -> Option<Places> {
        None
    }

    fn menu(&self, rows: &Rows) -> Vec<Further> {
        observe::menu(&self.0, rows)
    }

    fn equip(&self, active: &[Active]) -> Box<dyn Job> {
        Box::new(Pushed::equip(self.0.clone(), active))
    }
}

/// The effects that this process knows, by name.
fn effect(name: &str) -> Option<&'static dyn Effect<Curve>> {
    effects::ALL.iter().copied().find(|e| e.description().name == name)
}
