//! What to command so that the part comes out as the drawing asks.

use super::Error;
use crate::correct::Correction;
use crate::input::Problem;
use crate::model::Model;
use crate::progress::Progress;

/// The correction of a model whose values are known.
///
/// # Errors
/// Values are unknown, the process has no command that is corrected, or the model cannot be computed.
pub fn correct(model: &Model, progress: &Progress) -> Result<Correction, Error> {
    model.require_part()?;
    // On a thread of the pool: one from outside would wait for it at every evaluation.
    let found = rayon::scope(|_| crate::correct::correct(model, progress))?;
    found.ok_or_else(|| {
        let problem = Problem::new(format!("{} models {}", model.source.name, model.process.about()));
        problem.help("it has no command that is corrected: corrections are known of turning, ring, fixture, thermal, axis and contour").into()
    })
}
