//! The axis as effects shape it.

use std::sync::Arc;

use super::setup::Setup;
use crate::process::{self, Command};

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// Deviation (rad) at an angle (rad) and a time since the test began (s), the same from either side.
type Error = Box<dyn Fn(f64, f64) -> f64 + Send + Sync>;

/// A clearance (rad) or a torque (N·m) at an angle (rad).
type Course = Box<dyn Fn(f64) -> f64 + Send + Sync>;

/// A rotary axis with its effects. Effects act by play, by torques on a drive that yields, or by adding a deviation.
pub struct Machine {
    /// The tables of the model.
    pub setup: Arc<Setup>,
    /// Play that is the same all round, rad; below zero where more is compensated.
    pub gap: f64,
    /// Play that depends on the angle.
    plays: Vec<Course>,
    /// Torque of friction in the table's bearing and seals, N·m, against the motion.
    pub friction: f64,
    /// Torsional compliance of the drive at the table, rad/(N·m).
    pub compliance: f64,
    /// Torques that act on the table wherever it stands, towards +.
    torques: Vec<Course>,
    /// Deviations that add up.
    errors: Vec<Error>,
    /// What is added to the command, if it is corrected.
    pub command: Option<Arc<Command>>,
}

impl Machine {
    /// The ideal axis: it goes where it is told, but for what its drive gives way under a torque.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let compliance = if setup.is_closed() { 0.0 } else { 1.0 / setup.drive.stiffness };
        Self {
            setup,
            gap: 0.0,
            plays: Vec::new(),
            friction: 0.0,
            compliance,
            torques: Vec::new(),
            errors: Vec::new(),
            command: None,
        }
    }

    /// Adds a deviation, given the angle and the time.
    pub fn add(&mut self, error: impl Fn(f64, f64) -> f64 + Send + Sync + 'static) {
        self.errors.push(Box::new(error));
    }

    /// Adds play that depends on the angle.
    pub fn add_play(&mut self, play: impl Fn(f64) -> f64 + Send + Sync + 'static) {
        self.plays.push(Box::new(play));
    }

    /// Adds a torque on the table (N·m, towards +) that depends on the angle.
    pub fn add_torque(&mut self, torque: impl Fn(f64) -> f64 + Send + Sync + 'static) {
        self.torques.push(Box::new(torque));
    }

    /// Puts a torsional spring (N·m/rad) in series with the drive; infinite changes nothing.
    pub fn soften(&mut self, stiffness: f64) {
        self.compliance += 1.0 / stiffness;
    }

    /// Play in all at an angle (rad), rad.
    pub fn play(&self, angle: f64) -> f64 {
        self.gap + self.plays.iter().map(|play| play(angle)).sum::<f64>()
    }

    /// Torque (N·m, towards +) that effects put on the table at an angle (rad).
    pub fn load(&self, angle: f64) -> f64 {
        self.torques.iter().map(|torque| torque(angle)).sum()
    }

    /// Deviation (rad) that is the same from either side, at an angle (rad) and a time (s).
    pub fn error(&self, angle: f64, time: f64) -> f64 {
        self.errors.iter().map(|error| error(angle, time)).sum()
    }
}
