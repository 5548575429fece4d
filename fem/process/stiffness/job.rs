//! A joint with its effects, under test.

use std::sync::Arc;

use super::curve::Curve;
use super::model::Setup;
use super::{effects, findings, observe};
use crate::process::{Active, Failure, Job, Outcome, Rows, act};
use crate::progress::Progress;

/// A joint that predicts.
pub struct Pushed {
    /// What the model says.
    pub setup: Arc<Setup>,
    /// The joint with its effects.
    pub curve: Curve,
}

impl Pushed {
    /// Lets the effects act on a joint.
    pub fn equip(setup: Arc<Setup>, active: &[Active]) -> Self {
        let mut curve = Curve::ideal(&setup);
        act(effects::ALL, active, &mut curve);
        Self { setup, curve }
    }
}

impl Job for Pushed {
    /// Displacement in m, loading and then unloading.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        progress.expect(1);
        let displacements = observe::observe(self, &observe::programme(&self.setup));
        progress.advance(1);
        match displacements.iter().find(|y| y.is_nan() || y.abs() >= 1.0) {
            None => Ok(displacements),
            Some(y) => Err(Failure {
                message: format!("the displacement is {y:.3e} m somewhere: that is no joint any more"),
                help: "check forces and stiffness: a unit may be wrong".into(),
            }),
        }
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        Ok(observe::observe(self, rows))
    }

    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure> {
        Ok(findings::outcome(self, prediction))
    }
}
