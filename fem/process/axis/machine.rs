//! The axis as effects shape it.

use std::sync::Arc;

use super::model::Setup;
use crate::positioning::Direction;

/// An approach to a target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Commanded, m.
    pub position: f64,
    /// From which side.
    pub direction: Direction,
    /// Since the test began, s.
    pub time: f64,
}

/// What is lost at each reversal through elasticity: friction winds the drive up, either way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lost {
    /// F, N.
    pub friction: f64,
    /// Of nut, bearing and their seats, N/m.
    pub stiffness: f64,
}

/// A deviation that does not depend on the direction, m.
pub type Error = Box<dyn Fn(&Moment) -> f64 + Send + Sync>;

/// An axis with its effects. Effects act by play, by friction on the elastic drive, or by adding a deviation.
pub struct Machine {
    /// What the model says.
    pub setup: Arc<Setup>,
    /// Kinematic clearance δ, m.
    pub gap: f64,
    /// Elastic clearance.
    pub lost: Option<Lost>,
    /// Deviations that add up.
    pub errors: Vec<Error>,
}

impl Machine {
    /// The ideal axis: it goes where it is told.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        Self { setup, gap: 0.0, lost: None, errors: Vec::new() }
    }

    /// Adds a deviation, m.
    pub fn add(&mut self, error: impl Fn(&Moment) -> f64 + Send + Sync + 'static) {
        self.errors.push(Box::new(error));
    }

    /// How far friction holds the slide back with the nut at `position`, F/C(x), 1/C = 1/stiffness + the screw's own compliance; m.
    pub fn wind_up(&self, position: f64) -> f64 {
        self.lost.map_or(0.0, |l| l.friction * (1.0 / l.stiffness + self.setup.screw().compliance(position)))
    }

    /// Lost motion at a reversal at `position`: (kinematic, elastic), m.
    pub fn lost_motion(&self, position: f64) -> (f64, f64) {
        (self.gap, 2.0 * self.wind_up(position))
    }
}
