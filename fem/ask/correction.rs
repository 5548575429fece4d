//! What to command so that the part comes out as the drawing asks.

use super::Error;
use super::program::programmed;
use crate::correct::{Action, Advised, Correction};
use crate::gcode::Program;
use crate::input::Problem;
use crate::knowledge::failed;
use crate::model::Model;
use crate::process::range;
use crate::progress::Progress;
use crate::remedy::{NoRemedy, Remedies};

/// What to do about a model whose values are known: to correct its command, or else to change something; where a program is
/// given, by it, with blocks put between where it `adds` them.
///
/// # Errors
/// As those of [`correct`]; no block of the program finishes the part.
pub fn action(
    model: &Model,
    (program, adds): (Option<&Program>, bool),
    is_forced: bool,
    progress: &Progress,
) -> Result<Action, Error> {
    if model.system.commanded().is_none() && program.is_none() {
        return Ok(Action::Advice(Box::new(advise(model, is_forced, progress)?)));
    }
    let found = correct(model, is_forced, progress)?;
    let own = program.map(|program| programmed(model, &found, program, adds)).transpose()?;
    Ok(Action::Command(Box::new(found), own.map(Box::new)))
}

/// The correction of a model whose values are known.
///
/// # Errors
/// Values are unknown, the process has no command that is corrected, or the model cannot be computed.
pub fn correct(model: &Model, is_forced: bool, progress: &Progress) -> Result<Correction, Error> {
    model.require_part()?;
    require_fit(model, is_forced)?;
    // On a thread of the pool: one from outside would wait for it at every evaluation.
    let found = rayon::scope(|_| crate::correct::correct(model, progress))?;
    let found = found.ok_or_else(|| {
        let problem = Problem::new(format!("{} models {}", model.source.name, model.process.about()));
        problem.help("it has no command that is corrected: corrections are known of turning, ring, fixture, thermal, axis, rotary and contour")
    })?;
    within_limits(model, &found)?;
    Ok(found)
}

/// What to change at a model whose values are known, where no command of its process is corrected.
///
/// # Errors
/// Values are unknown, or the model cannot be computed.
fn advise(model: &Model, is_forced: bool, progress: &Progress) -> Result<Advised, Error> {
    model.require_part()?;
    require_fit(model, is_forced)?;
    // On a thread of the pool, as above.
    Ok(rayon::scope(|_| crate::correct::advise(model, progress))?)
}

/// What a shop should change: remedies of a model whose values are known, of at most `limit` (s) more than what is made now.
///
/// # Errors
/// Values are unknown, the model has no settings or names what it does not have, or it cannot be computed.
pub fn remedies(model: &Model, limit: Option<f64>, is_forced: bool, progress: &Progress) -> Result<Remedies, Error> {
    model.require_part()?;
    require_fit(model, is_forced)?;
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

/// Refuses a model that failed against the measurements that it was fitted to, unless that is known.
fn require_fit(model: &Model, is_forced: bool) -> Result<(), Problem> {
    let Some(failed) = failed(model.together.unexplained(), &model.process.size_kind()).filter(|_| !is_forced) else {
        return Ok(());
    };
    let problem = Problem::new(format!("{} {failed}", model.source.name));
    Err(problem.help(
        "`fem diagnose` looks for what is missing; --despite-failure goes on with it all the same, and says so in the answer",
    ))
}

/// Refuses what the machine may not be commanded.
fn within_limits(model: &Model, found: &Correction) -> Result<(), Problem> {
    let (low, high) = range(found.command.changes().iter().copied());
    let most = high.max(-low);
    let Some(largest) = model.largest_change.filter(|largest| most > *largest) else { return Ok(()) };
    let kind = model.process.size_kind();
    let (most, largest) = (kind.shown(most), kind.shown(largest));
    let problem = Problem::new(format!(
        "the {} would have to change by up to {most:.1}, and may by {largest:.1}: `largest` in [correction]",
        found.commanded.words
    ));
    let masked = found.masked.first().map(|own| format!("; {} is repaired rather than corrected", own.effect));
    Err(problem.help(format!(
        "a setting that leaves less comes first: `fem correct --remedies`{}",
        masked.unwrap_or_default()
    )))
}
