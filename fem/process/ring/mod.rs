//! Ring: the bore of a ring that a jaw chuck holds by its outside.
//!
//! The jaws squeeze the ring by u_r(θ), the bore is cut round, and released it moves back: deviation(θ) = −u_r(Ri, θ), positive outwards, θ = 0 at
//! jaw 1 [seed 002, ring in a three-jaw chuck]. Clamped and not yet bored it is +u_r. What the cut itself does wrong adds to the released bore.

mod circle;
mod drawn;
mod effects;
mod findings;
mod job;
mod machine;
mod model;
mod observe;
mod response;
mod shapes;
mod validation;

pub use drawn::Drawn;
pub use job::{BoreMotion, Ring as Chucked};
pub use machine::{Machine, Place};
pub use model::{Body, MeshSize, Reference, Setup};
pub use response::{BoreSeries, Jaw, Response, response};

use std::sync::Arc;

use super::{
    Active, Blind, Case, Coordinate, Description, Effect, Further, Job, Misplaced, Observable, Places, Process, Rows,
    Spot, System,
};
use crate::input::Reader;

/// The process `ring`.
pub struct Ring;

impl Process for Ring {
    fn name(&self) -> &'static str {
        "ring"
    }

    fn about(&self) -> &'static str {
        "bore of a ring clamped in a jaw chuck"
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
        Box::new(Chuck(Arc::new(Setup::read(model))))
    }

    fn validation(&self) -> Vec<Case> {
        validation::cases()
    }
}

/// A ring in its chuck, before any effect acts.
struct Chuck(Arc<Setup>);

impl System for Chuck {
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

    fn blind(&self, rows: &Rows) -> Vec<Blind> {
        observe::blind(&self.0, rows)
    }

    fn places(&self, rows: &Rows) -> Option<Places> {
        Some(observe::places(&self.0, rows))
    }

    fn contour(&self) -> Option<Vec<Vec<Spot>>> {
        Some(vec![Spot::circle(self.0.inner_radius)])
    }

    fn menu(&self, rows: &Rows) -> Vec<Further> {
        observe::menu(&self.0, rows)
    }

    fn equip(&self, active: &[Active]) -> Box<dyn Job> {
        Box::new(Chucked::equip(self.0.clone(), active))
    }
}

/// The effects that this process knows, by name.
fn effect(name: &str) -> Option<&'static dyn Effect<Machine>> {
    effects::ALL.iter().copied().find(|e| e.description().name == name)
}
