//! Two axes with their effects, at work.

use std::sync::Arc;

use super::machine::Machine;
use super::model::{AXES, Setup};
use super::{effects, findings, observe, shapes};
use crate::process::{Active, Failure, Job, Outcome, Rows, act};
use crate::progress::Progress;

/// Two axes that predict.
pub struct Contouring {
    /// With its effects.
    pub machine: Arc<Machine>,
}

impl Contouring {
    /// Lets the effects act on a set-up.
    pub fn equip(setup: Arc<Setup>, active: &[Active]) -> Self {
        let mut machine = Machine::ideal(setup);
        act(effects::ALL, active, &mut machine);
        Self { machine: Arc::new(machine) }
    }

    /// What the model says.
    pub fn setup(&self) -> &Setup {
        &self.machine.setup
    }

    /// The same, seen at no fewer points than these.
    #[must_use]
    pub fn with_points(&self, least: usize) -> Self {
        let mut machine = (*self.machine).clone();
        let setup = self.setup();
        machine.setup = Arc::new(Setup { points: setup.points.max(least), ..setup.clone() });
        Self { machine: Arc::new(machine) }
    }

    /// Refuses servos that do not follow.
    ///
    /// # Errors
    /// An axis has no gain left.
    pub fn check(&self) -> Result<(), Failure> {
        match (0..2).find(|axis| self.machine.gains[*axis] <= 0.0) {
            None => Ok(()),
            Some(axis) => Err(Failure {
                message: format!(
                    "the gain of {} is {:.3} /s: it does not follow its command",
                    AXES[axis], self.machine.gains[axis]
                ),
                help: "the mismatch of the gains must lie between -2 and 2".into(),
            }),
        }
    }
}

impl Job for Contouring {
    /// Deviation from the path in m, direction by direction.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        progress.expect(1);
        let deviations = observe::observe(self, &observe::programme(self.setup()))?;
        progress.advance(1);
        let reach = self.setup().path.reach();
        match deviations.iter().find(|d| d.is_nan() || d.abs() >= reach) {
            None => Ok(deviations),
            Some(deviation) => Err(Failure {
                message: format!("the tool is {deviation:.3e} m off its path somewhere: that is no contour any more"),
                help: "check feed, gain and dimensions: a unit may be wrong".into(),
            }),
        }
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        observe::observe(self, rows)
    }

    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure> {
        let mut outcome = findings::outcome(self, &prediction)?;
        outcome.drawings = vec![shapes::drawing(self, &prediction)];
        outcome.animation = Some(shapes::animation(self, &prediction));
        Ok(outcome)
    }
}
