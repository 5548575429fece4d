//! An axis with its effects, at work.

use std::sync::Arc;

use super::machine::{Machine, Moment};
use super::model::Setup;
use super::{effects, findings, observe, shapes};
use crate::positioning::Direction;
use crate::process::{Active, Failure, Job, Outcome, Rows, act};
use crate::progress::Progress;

/// An axis that predicts.
pub struct Axis {
    /// With its effects.
    pub machine: Arc<Machine>,
}

impl Axis {
    /// Lets the effects act on an axis.
    pub fn equip(setup: Arc<Setup>, active: &[Active]) -> Self {
        let mut machine = Machine::ideal(setup);
        act(effects::ALL, active, &mut machine);
        Self { machine: Arc::new(machine) }
    }

    /// Deviation of one approach, m: forwards the slide hangs back by the drive's wind-up; backwards too, and by the gap besides.
    pub fn deviation(&self, at: &Moment) -> f64 {
        let reversal = match at.direction {
            Direction::Forward => -self.machine.wind_up(at.position),
            Direction::Backward => self.machine.gap + self.machine.wind_up(at.position),
        };
        reversal + self.machine.errors.iter().map(|error| error(at)).sum::<f64>()
    }
}

impl Job for Axis {
    /// Deviations of the model's own test in m.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        progress.expect(1);
        let deviations = self.observe(&observe::programme(&self.machine.setup))?;
        progress.advance(1);
        match deviations.iter().find(|d| d.is_nan() || d.abs() >= self.machine.setup.travel) {
            None => Ok(deviations),
            Some(deviation) => Err(Failure {
                message: format!("the deviation is {deviation:.3e} m somewhere: as large as the travel"),
                help: "check friction, stiffness and slopes: a unit may be wrong".into(),
            }),
        }
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        Ok((0..rows.len()).map(|row| self.deviation(&observe::moment(rows, row))).collect())
    }

    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure> {
        let mut outcome = findings::outcome(self, &prediction);
        outcome.animation = Some(shapes::animation(self));
        Ok(outcome)
    }
}
