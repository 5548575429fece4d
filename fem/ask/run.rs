//! What a model predicts, and how far that may be off.

use crate::knowledge::{Band, Knowledge};
use crate::model::{Model, Run};
use crate::process::{Failure, Rows};
use crate::progress::Progress;

/// Runs a model, and finds the band that holds the truth about its prediction with 95 %, its values drawn together; none where the
/// model knows everything exactly.
///
/// # Errors
/// The model cannot be computed.
pub fn run(model: &Model, progress: &Progress) -> Result<(Run, Option<Band>), Failure> {
    let mut run = model.run(progress)?;
    if Knowledge::of(model).is_exact() {
        return Ok((run, None));
    }
    let rows = model.open_programme();
    // A prediction is one though nobody can say how far it may be off.
    match banded(model, &rows, &run.prediction, progress) {
        Ok(band) => Ok((run, Some(band))),
        Err(failure) => {
            run.report.warnings.push(failure.message);
            Ok((run, None))
        }
    }
}

/// Predicts rows of a model with the band that holds the truth about each with 95 %; of a model that knows everything exactly it
/// has no width.
///
/// # Errors
/// The model cannot be computed, or what its values may be makes none.
pub fn predict(model: &Model, rows: &Rows, progress: &Progress) -> Result<(Vec<f64>, Band), Failure> {
    let predicted = model.forward().observe(rows)?;
    let band = banded(model, rows, &predicted, progress)?;
    Ok((predicted, band))
}

fn banded(model: &Model, rows: &Rows, predicted: &[f64], progress: &Progress) -> Result<Band, Failure> {
    // On a thread of the pool: one from outside would wait for it at every draw.
    progress.stretch("what is known of it", || rayon::scope(|_| Band::about(model, rows, predicted)))
}
