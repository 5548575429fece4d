//! The body and its surroundings as effects shape them.

use std::sync::Arc;

use super::model::{Setup, Source};

/// Surroundings whose temperature swings: a(t) = amplitude·[sin(ωt + phase) − sin phase].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// K.
    pub amplitude: f64,
    /// rad/s.
    pub omega: f64,
    /// rad.
    pub phase: f64,
}

/// A thermal joint across the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// m from the base.
    pub at: f64,
    /// W/(m² K).
    pub conductance: f64,
}

/// A body in its surroundings with their effects. Effects open ways for heat, bring more of it, or delay what instruments show.
#[derive(Clone, Debug)]
pub struct Machine {
    /// What the model says.
    pub setup: Arc<Setup>,
    /// Film coefficient of all that is free, W/(m² K).
    pub convection: f64,
    /// From x = 0 to the surroundings, W/K.
    pub base: f64,
    /// Of the surroundings, one on top of the other.
    pub drifts: Vec<Drift>,
    /// The model's, then those of effects.
    pub sources: Vec<Source>,
    /// Of a rod.
    pub contacts: Vec<Contact>,
    /// Time constant of temperature sensors, s.
    pub lag: f64,
}

impl Machine {
    /// The ideal body: insulated, in one piece, in surroundings that stay as they are, with instant sensors.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let sources = setup.sources.clone();
        Self { setup, convection: 0.0, base: 0.0, drifts: Vec::new(), sources, contacts: Vec::new(), lag: 0.0 }
    }

    /// Rise of the surroundings at a time (s), K.
    pub fn around(&self, time: f64) -> f64 {
        let rise = |d: &Drift| d.amplitude * ((d.omega * time + d.phase).sin() - d.phase.sin());
        self.drifts.iter().map(rise).sum()
    }
}
