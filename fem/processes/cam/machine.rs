//! The grinder as effects shape it.

use std::sync::Arc;

use super::before::Before;
use super::motion::{Axes, Motion, legs};
use super::program::Pass;
use super::setup::{Setup, feed};
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

/// A pass as the machine makes it.
#[derive(Clone, Debug)]
pub struct Run {
    /// The pass.
    pub pass: Pass,
    /// Its motion.
    pub motion: Motion,
    /// The motion of the pass before, where its programme was another.
    pub before: Option<Motion>,
}

impl Machine {
    /// The ideal grinder.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        Self { setup, wear: 0.0, lag: 0.0, gap: 0.0, height: 0.0, compliance: 0.0 }
    }

    /// A pass with its motion, and that of the pass before it.
    pub fn run(&self, pass: Pass) -> Run {
        let setup = &self.setup;
        let program = &setup.program;
        // At twice the speed a lag is twice as long a part of the turn.
        let lag = self.lag * pass.speed / program.mean_speed;
        let reversed = pass.is_reversed.then(|| program.axes.reversed());
        let axes = reversed.as_ref().unwrap_or(&program.axes);
        let before = |b: &Before| self.motion(&b.program.axes, self.lag, b.wheel_radius);
        Run { pass, motion: self.motion(axes, lag, setup.wheel_radius), before: setup.before.as_ref().map(before) }
    }

    /// The motion of axes. Its blocks are numbered as they are executed.
    fn motion(&self, axes: &Axes, lag: f64, wheel_radius: f64) -> Motion {
        Motion::new(legs(axes, lag, self.gap, self.height), wheel_radius - self.wear)
    }

    /// The part of a layer that is left because wheel and cam give way to the force of the cut at s: F/k =
    /// part·layer with F = force_per_rate·layer·feed.
    pub fn yielding(&self, s: f64, pass: Pass) -> f64 {
        let setup = &self.setup;
        let speed = pass.speed / setup.program.mean_speed;
        self.part_left(|| speed * feed(&setup.profile, &setup.program, setup.wheel_radius, s))
    }

    /// Stock that the pass before has left at s by yielding, m.
    pub fn left_before(&self, before: &Before, s: f64) -> f64 {
        before.stock * self.part_left(|| feed(&self.setup.profile, &before.program, before.wheel_radius, s))
    }

    fn part_left(&self, feed: impl Fn() -> f64) -> f64 {
        match self.compliance {
            0.0 => 0.0,
            compliance => compliance * self.setup.force_per_rate.unwrap_or(0.0) * feed(),
        }
    }
}
