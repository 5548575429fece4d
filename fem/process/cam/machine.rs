//! The grinder as effects shape it.

use std::sync::Arc;

use super::model::Setup;
use super::motion::{Motion, legs};

/// A grinder with its effects. Each changes one thing, so that they act in any order.
#[derive(Clone, Debug)]
pub struct Machine {
    /// What the model says.
    pub setup: Arc<Setup>,
    /// What the wheel has lost of its radius since it was programmed, m.
    pub wear: f64,
    /// By how much the slide is late, s.
    pub lag: f64,
    /// Width of the play in the slide's feed, m.
    pub gap: f64,
    /// Of the wheel's centre above the cam's axis, m.
    pub height: f64,
    /// By how much wheel and cam give way to each other, m/N.
    pub compliance: f64,
}

/// How a cam is ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// Mean speed of the cam, rad/s.
    pub speed: f64,
    /// Whether the programme runs from its end to its beginning.
    pub is_reversed: bool,
}

impl Machine {
    /// The ideal grinder.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        Self { setup, wear: 0.0, lag: 0.0, gap: 0.0, height: 0.0, compliance: 0.0 }
    }

    /// Radius of the wheel as it is, m.
    pub fn wheel_radius(&self) -> f64 {
        self.setup.wheel_radius - self.wear
    }

    /// The programme as it runs when nothing is said.
    pub fn usual(&self) -> Pass {
        Pass { speed: self.setup.program.mean_speed, is_reversed: false }
    }

    /// The motion in a pass. Its blocks are numbered as they are executed.
    pub fn motion(&self, pass: Pass) -> Motion {
        let program = &self.setup.program;
        // At twice the speed a lag is twice as long a part of the turn.
        let lag = self.lag * pass.speed / program.mean_speed;
        let reversed = pass.is_reversed.then(|| program.axes.reversed());
        let axes = reversed.as_ref().unwrap_or(&program.axes);
        Motion::new(legs(axes, lag, self.gap, self.height), self.wheel_radius())
    }

    /// What is left because wheel and cam give way to the force of the cut, m: F/k with F = force_per_rate·stock·feed.
    pub fn given_way(&self, s: f64, pass: Pass) -> f64 {
        if self.compliance == 0.0 {
            return 0.0;
        }
        let setup = &self.setup;
        let rate = setup.stock.unwrap_or(0.0) * setup.feed(s) * pass.speed / setup.program.mean_speed;
        self.compliance * setup.force_per_rate.unwrap_or(0.0) * rate
    }
}
