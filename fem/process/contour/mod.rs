//! Contour: a circle or a rectangle that two servo axes travel together.
//!
//! Command → each axis behind its servo 1/(1 + s/Kv) → play → cyclic error → scale → squareness → centre → deviation from the path, positive outwards, plus
//! spikes: in that order, in the steady state that laps before have brought about, at the commanded point [seed 000; ISO 230-4].

mod circle;
mod effects;
mod findings;
mod job;
mod machine;
mod model;
mod motion;
mod observe;
mod path;
mod rectangle;
mod reversing;
mod shapes;
mod validation;

pub use job::Contouring;
pub use machine::{Lap, Machine};
pub use model::Setup;
pub use path::{Direction, Path};

use std::sync::Arc;

use super::{
    Active, Case, Coordinate, Description, Effect, Further, Job, Misplaced, Observable, Places, Process, Rows, Spot,
    System,
};
use crate::input::Reader;

/// The process `contour`.
pub struct Contour;

impl Process for Contour {
    fn name(&self) -> &'static str {
        "contour"
    }

    fn about(&self) -> &'static str {
        "circle or rectangle travelled by two servo axes"
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
        Box::new(TwoAxes(Arc::new(Setup::read(model))))
    }

    fn validation(&self) -> Vec<Case> {
        validation::cases()
    }
}

/// Two axes on their path, before any effect acts.
struct TwoAxes(Arc<Setup>);

impl System for TwoAxes {
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
        observe::resolved(&self.0, rows)
    }

    fn places(&self, rows: &Rows) -> Option<Places> {
        Some(shapes::places(&self.0, rows))
    }

    fn contour(&self) -> Option<Vec<Vec<Spot>>> {
        Some(self.0.path.drawn())
    }

    fn menu(&self, rows: &Rows) -> Vec<Further> {
        observe::menu(&self.0, rows)
    }

    fn equip(&self, active: &[Active]) -> Box<dyn Job> {
        Box::new(Contouring::equip(self.0.clone(), active))
    }
}

/// The effects that this process knows, by name.
fn effect(name: &str) -> Option<&'static dyn Effect<Machine>> {
    effects::ALL.iter().copied().find(|e| e.description().name == name)
}
