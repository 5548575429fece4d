//! The grinder as effects shape it.

use std::sync::Arc;

use super::motion::{Motion, legs};
use super::program::Pass;
use super::setup::Setup;
use crate::process;

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// A grinder with its effects. Each changes one thing, so that they act in any order.
#[derive(Clone, Debug)]
pub struct Machine {
    /// The tables of the model.
    pub setup: Arc<Setup>,
    /// Radius that the wheel has lost since it was programmed, m.
    pub wear: f64,
    /// Time by which the slide is late, s.
    pub lag: f64,
    /// Width of the play in the slide's feed, m.
    pub gap: f64,
    /// Height of the wheel's centre above the cam's axis, m.
    pub height: f64,
    /// Compliance of wheel, slide and cam against each other, m/N.
    pub compliance: f64,
}

impl Machine {
    /// The ideal grinder.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        Self { setup, wear: 0.0, lag: 0.0, gap: 0.0, height: 0.0, compliance: 0.0 }
    }

    /// The motion in a pass. Its blocks are numbered as they are executed.
    pub fn motion(&self, pass: Pass) -> Motion {
        let program = &self.setup.program;
        // At twice the speed a lag is twice as long a part of the turn.
        let lag = self.lag * pass.speed / program.mean_speed;
        let reversed = pass.is_reversed.then(|| program.axes.reversed());
        let axes = reversed.as_ref().unwrap_or(&program.axes);
        Motion::new(legs(axes, lag, self.gap, self.height), self.setup.wheel_radius - self.wear)
    }

    /// The deviation that is left because wheel and cam give way to the force of the cut, m: F/k with F =
    /// force_per_rate·stock·feed.
    pub fn given_way(&self, s: f64, pass: Pass) -> f64 {
        if self.compliance == 0.0 {
            return 0.0;
        }
        let setup = &self.setup;
        let rate = setup.stock.unwrap_or(0.0) * setup.feed(s) * pass.speed / setup.program.mean_speed;
        self.compliance * setup.force_per_rate.unwrap_or(0.0) * rate
    }
}
