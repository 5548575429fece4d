//! Axis: where a feed axis really goes.
//!
//! deviation = actual − commanded position, at a target approached forwards (`+`) or backwards (`-`), in a run, at a time. The ideal axis goes where it
//! is told; the ball screw is a bar on its bearing, stretched by whatever the slide's friction asks of it [seed 000, fig. 2].

mod effects;
mod findings;
mod job;
mod machine;
mod model;
mod observe;
mod shapes;
mod validation;

pub use job::Axis as Driven;
pub use machine::{Lost, Machine, Moment};
pub use model::{Setup, Spacing};

use std::sync::Arc;

use super::{
    Active, Case, Coordinate, Description, Effect, Further, Job, Misplaced, Observable, Places, Positioning, Process,
    Rows, System,
};
use crate::input::Reader;

/// The process `axis`.
pub struct Axis;

impl Process for Axis {
    fn name(&self) -> &'static str {
        "axis"
    }

    fn about(&self) -> &'static str {
        "positioning of a feed axis driven by a ball screw"
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
        Box::new(Slide(Arc::new(Setup::read(model))))
    }

    fn validation(&self) -> Vec<Case> {
        validation::cases()
    }
}

/// An axis before any effect acts.
struct Slide(Arc<Setup>);

impl System for Slide {
    fn admits(&self, effect: &str) -> Result<(), String> {
        self.0.admits(effect)
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

    fn places(&self, rows: &Rows) -> Option<Places> {
        Some(observe::places(rows))
    }

    fn menu(&self, rows: &Rows) -> Vec<Further> {
        observe::menu(&self.0, rows)
    }

    fn positioning(&self) -> Option<&dyn Positioning> {
        Some(&*self.0)
    }

    fn equip(&self, active: &[Active]) -> Box<dyn Job> {
        Box::new(Driven::equip(self.0.clone(), active))
    }
}

/// The effects that this process knows, by name.
fn effect(name: &str) -> Option<&'static dyn Effect<Machine>> {
    effects::ALL.iter().copied().find(|e| e.description().name == name)
}
