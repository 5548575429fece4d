//! A body with its effects, through time.

use std::sync::Arc;

use super::machine::Machine;
use super::model::{Setup, Time};
use super::{effects, findings, observe, shapes};
use crate::process::{Active, Failure, Job, Outcome, Rows, act};
use crate::progress::Progress;

/// A heated body that predicts.
pub struct Heated {
    /// With its effects.
    pub machine: Arc<Machine>,
}

impl Heated {
    /// Lets the effects act on a set-up.
    pub fn equip(setup: Arc<Setup>, active: &[Active]) -> Self {
        let mut machine = Machine::ideal(setup);
        act(effects::ALL, active, &mut machine);
        Self { machine: Arc::new(machine) }
    }

    /// The same in elements twice as long, where they are the program's own, and in these steps (s).
    #[must_use]
    pub fn coarser(&self, step: f64) -> Self {
        let mut machine = (*self.machine).clone();
        let setup = self.setup();
        let time = Time { step: Some(step), ..setup.time };
        machine.setup = Arc::new(Setup { time, element_size: 2.0 * setup.element_size, ..setup.clone() });
        Self { machine: Arc::new(machine) }
    }

    /// What the model says.
    pub fn setup(&self) -> &Setup {
        &self.machine.setup
    }
}

impl Job for Heated {
    /// Elongation (m) and temperatures (K) at every time of the programme.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        progress.expect(1);
        let observed = observe::observe(self, &observe::programme(self.setup()))?;
        progress.advance(1);
        /// Steel boils.
        const HOTTEST: f64 = 5000.0;
        match observed.iter().find(|v| v.is_nan() || v.abs() >= HOTTEST) {
            None => Ok(observed),
            Some(value) => Err(Failure {
                message: format!("a temperature becomes {value:.3e} K: no body stands that"),
                help: "check powers, fluxes and dimensions: a unit may be wrong".into(),
            }),
        }
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        observe::observe(self, rows)
    }

    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure> {
        let scene = shapes::Scene::new(self)?;
        let mut outcome = findings::outcome(self, &scene, prediction)?;
        outcome.animation = Some(scene.animation());
        Ok(outcome)
    }
}
