//! The machine as effects shape it.

use std::sync::Arc;

use super::play::Play;
use super::setup::Setup;
use crate::process::{self, Command};

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// A machine with its effects, the axes by their position: x, y.
#[derive(Clone, Debug, PartialEq)]
pub struct Machine {
    /// The tables of the model.
    pub setup: Arc<Setup>,
    /// Kv of each axis, 1/s.
    pub gains: [f64; 2],
    /// Lost motion of each axis.
    pub plays: [Play; 2],
    /// Compliance between tool and work along each axis, m/N.
    pub compliances: [f64; 2],
    /// Part by which each gain changes when its axis goes at the feed of the model.
    pub gain_changes: [f64; 2],
    /// Wave of each axis over time, its phase when the lap begins.
    pub stick_slip: [Cyclic; 2],
    /// Cyclic error of each axis.
    pub cyclic: [Cyclic; 2],
    /// Travel of each axis over what its scale shows.
    pub scales: [f64; 2],
    /// Angle by which the y axis leans towards x, rad.
    pub squareness: f64,
    /// Place of the programmed centre for whoever measures, m.
    pub centre: [f64; 2],
    /// Mark that each axis leaves when it turns round.
    pub spikes: [Spike; 2],
    /// What is added to the command, if it is corrected.
    pub command: Option<Arc<Command>>,
}

/// amplitude·sin(2π·position/lead + phase).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cyclic {
    /// Half of peak to valley, m.
    pub amplitude: f64,
    /// Phase at the contour's centre, rad.
    pub phase: f64,
}

/// height·e^(−Δt/time_constant), outwards along the axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spike {
    /// Height at the reversal, m.
    pub height: f64,
    /// Time in which it fades to 1/e, s.
    pub time_constant: f64,
}

impl Machine {
    /// The ideal machine: two equal servos and nothing else.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let gains = [setup.gain; 2];
        Self {
            setup,
            gains,
            plays: Default::default(),
            compliances: [0.0; 2],
            gain_changes: [0.0; 2],
            stick_slip: [Cyclic::default(); 2],
            cyclic: [Cyclic::default(); 2],
            scales: [1.0; 2],
            squareness: 0.0,
            centre: [0.0; 2],
            spikes: [Spike::default(); 2],
            command: None,
        }
    }

    /// Gain of an axis at its own speed (m/s), 1/s.
    pub fn gain_at(&self, axis: usize, speed: f64) -> f64 {
        self.gains[axis] * (1.0 + self.gain_changes[axis] * speed.abs() / self.setup.feed)
    }
}
