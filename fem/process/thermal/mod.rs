//! Thermal: temperature and growth of a body that is heated, over time.
//!
//! A rod by one-dimensional conduction with sources at points, ρcA T_t = (kA T_x)_x − h p (T − T_a) + Σ Q δ, or a plane body by finite elements. All
//! is at the temperature of the surroundings at the start; surfaces and ends are insulated unless an effect, or an edge of a plane body, opens
//! them. The free end moves by ∫ α (T − T₀) dx [seed 002 (35)–(39)]; a plane body also bows where it is warmer above than below.

mod body;
mod effects;
mod findings;
mod follow;
mod job;
mod machine;
mod model;
mod observe;
mod plate;
mod rod;
mod shapes;
mod validation;

pub use body::{Body, Plane};
pub use follow::{Followed, Look, Span};
pub use job::Heated;
pub use machine::{Contact, Drift, Machine};
pub use model::{Boundary, Condition, Setup, Source, Time};

use std::sync::Arc;

use super::{
    Active, Case, Coordinate, Description, Effect, Further, Job, Misplaced, Observable, Places, Process, Rows, System,
};
use crate::input::Reader;

/// The process `thermal`.
pub struct Thermal;

impl Process for Thermal {
    fn name(&self) -> &'static str {
        "thermal"
    }

    fn about(&self) -> &'static str {
        "temperature and growth of a heated body over time"
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

/// A body with its heaters, before any effect acts.
struct Bench(Arc<Setup>);

impl System for Bench {
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

    fn places(&self, _: &Rows) -> Option<Places> {
        None
    }

    fn reach(&self, coordinate: &str) -> Option<(f64, f64)> {
        match (&self.0.body, coordinate) {
            (Body::Plane(plane), "x") => Some(plane.extent(0).into()),
            (rod, "x") => Some((0.0, rod.length())),
            _ => None,
        }
    }

    fn menu(&self, rows: &Rows) -> Vec<Further> {
        observe::menu(&self.0, rows)
    }

    fn equip(&self, active: &[Active]) -> Box<dyn Job> {
        Box::new(Heated::equip(self.0.clone(), active))
    }
}

/// The effects that this process knows, by name.
fn effect(name: &str) -> Option<&'static dyn Effect<Machine>> {
    effects::ALL.iter().copied().find(|e| e.description().name == name)
}
