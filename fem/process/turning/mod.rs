//! Turning: the diameter profile of every part of a batch of shafts.
//!
//! The tool stands at x and pushes the shaft away by y(x); the diameter grows by ΔD = 2·y(x), and everything that moves the
//! tool nose toward or away from the axis adds to it.

mod cut;
mod effects;
mod elastic;
mod findings;
mod job;
mod lathe;
mod machine;
mod menu;
mod model;
mod observe;
mod passes;
mod refinement;
mod schedule;
mod shapes;
mod validation;

pub use super::Segment;
pub use cut::{Cut, Force, ForceLaw};
pub use elastic::{Conditions, Deflection, Elastic};
pub use lathe::Lathe;
pub use machine::{Machine, Moment};
pub use model::{Setup, Workholding};
pub use passes::{Blank, EarlierPass};
pub use schedule::Schedule;

use std::sync::Arc;

use super::{
    Active, Case, Coordinate, Description, Effect, Further, Job, Misplaced, Observable, Places, Process, Rows, System,
};
use crate::input::Reader;

/// The process `turning`.
pub struct Turning;

impl Process for Turning {
    fn name(&self) -> &'static str {
        "turning"
    }

    fn about(&self) -> &'static str {
        "diameter profile of every shaft of a turned batch"
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

/// A set-up lathe, before any effect acts.
struct Bench(Arc<Setup>);

impl System for Bench {
    fn admits(&self, effect: &str) -> Result<(), String> {
        self.0.workholding.admits(effect)
    }

    fn misplaced(&self, rows: &Rows) -> Vec<Misplaced> {
        observe::misplaced(&self.0, rows)
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

    fn menu(&self, rows: &Rows) -> Vec<Further> {
        menu::menu(&self.0, rows)
    }

    fn equip(&self, active: &[Active]) -> Box<dyn Job> {
        Box::new(Lathe::equip(self.0.clone(), active))
    }
}

/// The effects that this process knows, by name.
fn effect(name: &str) -> Option<&'static dyn Effect<Machine>> {
    effects::ALL.iter().copied().find(|e| e.description().name == name)
}
