//! A grinder with its effects, at work.

use std::sync::Arc;

use rayon::prelude::*;

use super::machine::{Machine, Pass};
use super::model::Setup;
use super::motion::Motion;
use super::{effects, findings, observe, report, shapes};
use crate::process::{Active, Failure, Job, Outcome, Rows, act};
use crate::progress::Progress;

/// A grinder that predicts.
pub struct Cam {
    /// With its effects.
    pub machine: Machine,
}

impl Cam {
    /// Lets the effects act on a set-up.
    pub fn equip(setup: Arc<Setup>, active: &[Active]) -> Self {
        let mut machine = Machine::ideal(setup);
        act(effects::ALL, active, &mut machine);
        Self { machine }
    }

    /// What the model says.
    pub fn setup(&self) -> &Setup {
        &self.machine.setup
    }

    /// The deviation at the place s of the profile, m.
    ///
    /// # Errors
    /// The wheel does not come there.
    pub fn deviation(&self, motion: &Motion, s: f64, pass: Pass) -> Result<f64, Failure> {
        match observe::left_at(self.setup(), motion, s, pass) {
            Some(left) => Ok(left + self.machine.given_way(s, pass)),
            None => Err(Failure {
                message: format!(
                    "the wheel does not come to the cam at {:.2} deg",
                    self.setup().profile.angle(s).to_degrees()
                ),
                help: "check the wheel, the profile and the sizes of the effects: a unit may be wrong".into(),
            }),
        }
    }
}

impl Job for Cam {
    /// Deviation in m at the model's own points, block by block.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        progress.expect(1);
        let pass = self.machine.usual();
        let motion = self.machine.motion(pass);
        let places = self.setup().places();
        let deviations: Result<Vec<f64>, Failure> =
            places.par_iter().map(|s| self.deviation(&motion, *s, pass)).collect();
        progress.advance(1);
        deviations
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        observe::observe(self, rows)
    }

    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure> {
        let motion = self.machine.motion(self.machine.usual());
        let report = report::report(&self.machine, &motion);
        let mut outcome = findings::outcome(self, &report, &prediction);
        outcome.animation = Some(shapes::animation(self, motion, prediction));
        Ok(outcome)
    }
}
