//! The axis as effects shape it.

use std::sync::Arc;

use super::setup::Setup;
use crate::process::{self, Command, Winding};

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// Deviation (m) at a commanded position (m) and a time since the test began (s), the same from either side.
pub type Error = Box<dyn Fn(f64, f64) -> f64 + Send + Sync>;

/// Clearance (m) at a position (m).
type Play = Box<dyn Fn(f64) -> f64 + Send + Sync>;

/// An axis with its effects. Effects act by play, by friction on the elastic drive, or by adding a
/// deviation.
pub struct Machine {
    /// The tables of the model.
    pub setup: Arc<Setup>,
    /// Kinematic clearance δ that is the same all along, m; below zero where more is compensated.
    pub gap: f64,
    /// Kinematic clearance that depends on the place.
    plays: Vec<Play>,
    /// Elastic clearance.
    pub winding: Option<Winding>,
    /// Deviations that add up.
    pub errors: Vec<Error>,
    /// What is added to the command, if it is corrected.
    pub command: Option<Arc<Command>>,
}

impl Machine {
    /// The ideal axis: it goes where it is told.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        Self { setup, gap: 0.0, plays: Vec::new(), winding: None, errors: Vec::new(), command: None }
    }

    /// Adds a deviation.
    pub fn add(&mut self, error: impl Fn(f64, f64) -> f64 + Send + Sync + 'static) {
        self.errors.push(Box::new(error));
    }

    /// Adds clearance that depends on the place.
    pub fn add_play(&mut self, play: impl Fn(f64) -> f64 + Send + Sync + 'static) {
        self.plays.push(Box::new(play));
    }

    /// Kinematic clearance in all at a position (m), m.
    pub fn play(&self, position: f64) -> f64 {
        self.gap + self.plays.iter().map(|play| play(position)).sum::<f64>()
    }

    /// Friction (N) of the slide at a position (m).
    pub fn friction(&self, position: f64) -> f64 {
        let drag = self.setup.drag.as_ref().map_or(1.0, |drag| drag.at(position));
        self.winding.as_ref().map_or(0.0, |winding| drag * winding.friction)
    }

    /// How far the drive gives way under a force (N) at a position (m), m, of the sign of the force: of what is stiff the
    /// screw alone.
    pub fn bend(&self, force: f64, position: f64) -> f64 {
        let bend = match &self.winding {
            Some(winding) => winding.under(force.abs(), position),
            None => force.abs() * self.setup.screw().compliance(position),
        };
        bend.copysign(force)
    }

    /// How far friction holds the slide back with the nut at `position` (m), m: by what it is there, where the model
    /// says how it goes along the travel.
    pub fn wind_up(&self, position: f64) -> f64 {
        let Some(winding) = &self.winding else { return 0.0 };
        match &self.setup.drag {
            Some(drag) => winding.under(drag.at(position) * winding.friction, position),
            None => winding.displacement(position),
        }
    }
}
