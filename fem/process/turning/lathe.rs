//! A lathe with its effects, at work.

use std::sync::Arc;

use rayon::prelude::*;

use super::effects;
use super::elastic::{Conditions, Deflection, Elastic};
use super::machine::{Machine, Moment};
use super::model::Setup;
use crate::process::{Active, Failure, act};
use crate::progress::Progress;
use crate::solve::{Condensed, JointsError, ShaftError};

/// A machine that predicts.
pub struct Lathe {
    /// With its effects.
    pub machine: Arc<Machine>,
}

impl Lathe {
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

    /// The shaft as the machine holds it, condensed to tool positions in m.
    ///
    /// # Errors
    /// An effect cannot be computed, the shaft is loose, or a position is off it.
    pub fn condense(&self, positions: &[f64]) -> Result<Condensed, Failure> {
        if let Some(failure) = &self.machine.failure {
            return Err(failure.clone());
        }
        self.setup().shaft(self.machine.hold).condense(positions).map_err(Failure::from)
    }

    /// Force and depth of the last pass at the model's own settings, where the passes before have left an error of the diameter (m).
    pub fn conditions(&self, error: f64) -> Conditions {
        let (force, depth) = (self.setup().nominal_force(), self.setup().cut.depth);
        Conditions { force, nominal: force, nominal_depth: depth, set_depth: depth + 0.5 * error }
    }

    /// The equilibrium of the last pass at each of the positions (m) to which the shaft is condensed.
    ///
    /// # Errors
    /// No equilibrium at some position.
    pub fn deflections(
        &self,
        shaft: &Condensed,
        positions: &[f64],
        progress: &Progress,
    ) -> Result<Vec<Deflection>, Failure> {
        let elastic = Elastic::new(&self.machine, shaft);
        let deflect = |i: usize| {
            let before = elastic.before(i, positions[i]);
            let deflection = before.and_then(|before| elastic.deflect(i, self.conditions(before)));
            progress.advance(1);
            deflection
        };
        progress.expect(shaft.compliance.len() as u64);
        let all: Result<Vec<_>, _> =
            (0..shaft.compliance.len()).into_par_iter().with_min_len(64).map(deflect).collect();
        all.map_err(Failure::from)
    }

    /// Everything but force that changes the diameter when the tool is at `x` on `part`, m.
    pub fn shift(&self, part: usize, x: f64) -> f64 {
        let schedule = &self.setup().schedule;
        self.shift_at(&Moment {
            x,
            diameter: self.setup().diameter(x),
            time: schedule.time(part, x),
            path: schedule.path(part, x),
        })
    }

    /// The same at any moment.
    pub(super) fn shift_at(&self, moment: &Moment) -> f64 {
        self.machine.shifts.iter().map(|shift| shift(moment)).sum()
    }
}

impl From<ShaftError> for Failure {
    fn from(error: ShaftError) -> Self {
        let help = match error {
            ShaftError::Loose { .. } => "give the shaft a stiffer support, or check its dimensions and stiffnesses",
            ShaftError::OffTheShaft { .. } => "keep every position between the ends of the shaft",
        };
        Self { message: error.to_string(), help: help.into() }
    }
}

impl From<JointsError> for Failure {
    fn from(error: JointsError) -> Self {
        let help = "check force, stiffnesses and contact parameters: values far from physical ones do not converge";
        Self { message: error.to_string(), help: help.into() }
    }
}
