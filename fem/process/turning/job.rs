//! What a lathe predicts: its own programme, measured rows, and the report of a run.

use rayon::prelude::*;

use super::lathe::Lathe;
use super::refinement::Refinement;
use super::{findings, observe, shapes};
use crate::process::{Failure, Job, Outcome, Rows};
use crate::progress::Progress;

impl Job for Lathe {
    /// ΔD in m, part by part, x rising.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        let positions = self.setup().sweep();
        let shaft = self.condense(&positions)?;
        let deflections = self.deflections(&shaft, &positions, progress)?;
        let parts = self.setup().schedule.parts;
        let mut errors = vec![0.0; parts * positions.len()];
        progress.expect(parts as u64);
        errors.par_chunks_mut(positions.len()).enumerate().for_each(|(k, errors)| {
            for ((error, &x), deflection) in errors.iter_mut().zip(&positions).zip(&deflections) {
                *error = 2.0 * deflection.total + self.shift(k + 1, x);
            }
            progress.advance(1);
        });
        believable(errors)
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        observe::observe(self, rows)
    }

    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure> {
        let positions = self.setup().sweep();
        let shaft = self.condense(&positions)?;
        let deflections = self.deflections(&shaft, &positions, &Progress::default())?;
        let mut outcome = findings::outcome(self, &positions, &deflections, prediction)?;
        if let Some(refinement) = Refinement::of(self, &positions)? {
            outcome.findings.push(refinement.finding());
            outcome.tables.push(("passes", refinement.table(&positions)));
        }
        outcome.animation = Some(shapes::animation(self)?);
        Ok(outcome)
    }
}

/// No diameter is wrong by a kilometre: a number beyond it, or none, comes from values that cannot be meant.
fn believable(errors: Vec<f64>) -> Result<Vec<f64>, Failure> {
    match errors.iter().find(|e| e.is_nan() || e.abs() >= 1e3) {
        None => Ok(errors),
        Some(error) => Err(Failure {
            message: format!("the prediction is {error:.3e} m somewhere: no diameter can be so wrong"),
            help: "check the model for values that are far too large".into(),
        }),
    }
}
