//! The body and its surroundings as effects shape them.

use std::sync::{Arc, OnceLock};

use super::boundary::{Boundary, Condition};
use super::follow::Look;
use super::recording::Recording;
use super::setup::{Setup, Time};
use super::surroundings::Surroundings;
use crate::process::{self, Command};
use crate::solve::rod::{History, PointSource, Swing};

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// A thermal joint across the section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Place, m from the base.
    pub at: f64,
    /// Conductance per area, W/(m² K).
    pub conductance: f64,
}

/// A body in its surroundings with their effects: these open ways for heat, bring more of it, or delay what
/// instruments show.
#[derive(Clone, Debug)]
pub struct Machine {
    /// The tables of the model.
    pub setup: Arc<Setup>,
    /// Film coefficient of all that is free, W/(m² K).
    pub convection: f64,
    /// Conductance from x = 0 to the surroundings, W/K.
    pub base: f64,
    /// Drifts of the surroundings, one on top of the other.
    pub drifts: Vec<Swing>,
    /// Sources of the model, then those of effects.
    pub sources: Vec<PointSource>,
    /// Joints of a rod.
    pub contacts: Vec<Contact>,
    /// Time constant of temperature sensors, s.
    pub lag: f64,
    /// What is added to the command, if it is corrected.
    pub command: Option<Arc<Command>>,
    /// A plane body as it was followed for the prediction: the report shows the same run.
    pub recording: Arc<OnceLock<Arc<Recording>>>,
}

impl Machine {
    /// The ideal body: insulated, in one piece, in surroundings that stay as they are, with instant sensors.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let sources = setup.sources.clone();
        Self {
            setup,
            convection: 0.0,
            base: 0.0,
            drifts: Vec::new(),
            sources,
            contacts: Vec::new(),
            lag: 0.0,
            command: None,
            recording: Arc::default(),
        }
    }

    /// The same in elements twice as long, where they are the program's own, and in these steps (s).
    #[must_use]
    pub fn coarser(&self, step: f64) -> Self {
        let coarse = Setup { element_size: 2.0 * self.setup.element_size, ..(*self.setup).clone() };
        Self { setup: Arc::new(coarse), recording: Arc::default(), ..self.clone() }.with_step(step)
    }

    /// The same in these steps (s).
    #[must_use]
    pub fn with_step(&self, step: f64) -> Self {
        let time = Time { step: Some(step), ..self.setup.time };
        let setup = Arc::new(Setup { time, ..(*self.setup).clone() });
        Self { setup, recording: Arc::default(), ..self.clone() }
    }

    /// Rise of the surroundings over the body's temperature at the start, over time, K: as the model says,
    /// and the drifts on top of it.
    pub fn around(&self) -> History {
        let Setup { ambient, start, .. } = &*self.setup;
        let parts = [ambient.clone(), History::Constant(-start)].into_iter();
        History::Sum(parts.chain(self.drifts.iter().copied().map(History::Swing)).collect())
    }

    /// The same of what holds the base.
    pub fn around_base(&self) -> History {
        self.setup.at_base.as_ref().map_or_else(|| self.around(), |own| self.rise(own))
    }

    /// Rise of a temperature (K) over the body's at the start.
    pub fn rise(&self, temperature: &History) -> History {
        History::Sum(vec![temperature.clone(), History::Constant(-self.setup.start)])
    }

    /// Time constant of what shows a look, s: only temperatures are late.
    pub fn lag_of(&self, look: Look) -> f64 {
        if look.is_shape() { 0.0 } else { self.lag }
    }

    /// Whether the body feels the temperature of its surroundings.
    pub fn is_open(&self) -> bool {
        let loses = |edge: &Boundary| {
            matches!(
                edge.condition,
                Condition::Convection { ambient: None, .. } | Condition::Radiation { ambient: None, .. }
            )
        };
        let is_told = |s: &Surroundings| s.coefficient.is_some_and(|film| film > 0.0);
        let has_film = self.setup.sections.iter().any(is_told);
        self.convection > 0.0 || self.base > 0.0 || has_film || self.setup.boundaries.iter().any(loses)
    }
}
