//! What to command so that the part comes out as the drawing asks.

use super::Error;
use crate::correct::{Advised, Correction};
use crate::input::Problem;
use crate::model::Model;
use crate::progress::Progress;
use crate::remedy::{NoRemedy, Remedies};

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

/// What to change at a model whose values are known, where no command of its process is corrected.
///
/// # Errors
/// Values are unknown, or the model cannot be computed.
pub fn advise(model: &Model, progress: &Progress) -> Result<Advised, Error> {
    model.require_part()?;
    // On a thread of the pool, as above.
    Ok(rayon::scope(|_| crate::correct::advise(model, progress))?)
}

/// What a shop should change: remedies of a model whose values are known, of at most `limit` (s) more than what is made now.
///
/// # Errors
/// Values are unknown, the model has no settings or names what it does not have, or it cannot be computed.
pub fn remedies(model: &Model, limit: Option<f64>, progress: &Progress) -> Result<Remedies, Error> {
    model.require_part()?;
    if model.settings.is_empty() {
        let problem = Problem::new(format!("{} does not say what the shop can change", model.source.name));
        let help = "add [[setting]] with quantity = \"…\", from = \"…\" and to = \"…\" for each, and minutes = \"…\" that it costs";
        return Err(problem.help(help).into());
    }
    // On a thread of the pool, as above.
    rayon::scope(|_| crate::remedy::remedies(model, limit, progress)).map_err(|none| match none {
        NoRemedy::Input(error) => error.into(),
        NoRemedy::Compute(failure) => failure.into(),
    })
}
