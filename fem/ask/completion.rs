//! A model with what measurements tell of it.

use super::Error;
use crate::diagnose::{Diagnosis, Next};
use crate::fit::{Fit, has_nothing_to_fit};
use crate::input::Problem;
use crate::model::{Data, Entry, Model, Setting, add_effect};
use crate::output::{Addition, additions};
use crate::process::Failure;
use crate::progress::Progress;

/// Estimates what the model leaves open.
///
/// # Errors
/// It leaves nothing open, or cannot be computed.
pub fn fit(data: &Data) -> Result<Fit, Error> {
    if has_nothing_to_fit(data.model) {
        let problem = Problem::new(format!("{} has nothing to fit", data.model.source.name));
        return Err(problem.help("mark what is not exactly known: \"60 +- 15 N/um\" or \"? N/um\"").into());
    }
    Ok(crate::fit::fit(data)?)
}

/// The model with every fitted value that the data tell.
///
/// # Errors
/// A fitted value lies outside of what a model may hold, or the model cannot be run with it.
pub fn fitted(data: &Data, fit: &Fit) -> Result<Model, Error> {
    by_itself(data.model.edited(&crate::fit::edits(data, fit))?)
}

/// A model that runs as well as it compares: what its own programme asks of it may be far from where anybody measured, and
/// columns that only measurements have are in no programme.
fn by_itself(model: Model) -> Result<Model, Error> {
    let model = with_usual(model)?;
    if model.require_values().is_ok() {
        model.forward().predict(&Progress::default()).map_err(|Failure { message, help }| Failure {
            message: format!("with these values the model cannot be run, and is not written: {message}"),
            help,
        })?;
    }
    Ok(model)
}

/// The model with what columns of files usually are that its formulas name: where rows have none, as in a run, it is that.
///
/// # Errors
/// A column has a name that no key can have.
pub fn with_usual(model: Model) -> Result<Model, Problem> {
    match &*model.saying_usual() {
        [] => Ok(model),
        edits => model.edited(edits),
    }
}

/// A note on each column of which a model says what it usually is, and the one from which it was made did not.
pub fn usual_said(model: &Model, before: &Model) -> Vec<String> {
    let note = |said| format!("[recorded] has {said}, the median of the rows: it is what a run takes");
    model.usual_beside(before).into_iter().map(note).collect()
}

/// The model with the missing effects and every fitted value.
///
/// # Errors
/// As those of [`fitted`].
pub fn completed(data: &Data, diagnosis: &Diagnosis) -> Result<Model, Error> {
    let mut better = fitted(data, &diagnosis.fit)?;
    for addition in additions(data, diagnosis) {
        better = mended(&better, &addition)?;
    }
    by_itself(better)
}

/// The model with one cause seen to.
///
/// # Errors
/// As of adding an effect or another value.
pub fn mended(model: &Model, addition: &Addition) -> Result<Model, Problem> {
    match addition {
        Addition::Effect(name, settings) => add_effect(model, name, settings),
        // An effect that was left out has no values.
        Addition::Value(setting) if setting.key.starts_with("effects.") && model.effect_of(&setting.key).is_none() => {
            Ok(model.clone())
        }
        Addition::Value(setting) => super::revised(model, std::slice::from_ref(setting), &[]),
        Addition::Without(name) => super::revised(model, &[], std::slice::from_ref(name)),
    }
}

/// The model in which rows that are to be measured lie: that of the data, or one with more parts in its batch.
///
/// # Errors
/// As those of [`fitted`].
pub fn extended(model: &Model, next: &Next) -> Result<Option<Model>, Error> {
    let Some((key, count)) = next.experiment.raises else { return Ok(None) };
    let setting = Setting { key: key.into(), value: Entry::Whole(i64::try_from(count).unwrap_or(i64::MAX)) };
    Ok(Some(super::revised(model, &[setting], &[])?))
}

/// The model with one missing effect after the other, each with its name, as far as values go that a model may hold.
pub fn steps(data: &Data, diagnosis: &Diagnosis) -> Vec<(String, Model)> {
    let mut model = data.model.clone();
    let mut steps = Vec::new();
    for addition in additions(data, diagnosis) {
        let Ok(better) = mended(&model, &addition) else { break };
        steps.push((addition.name().to_string(), better.clone()));
        model = better;
    }
    steps
}

/// Notes beside a diagnosis: on the files, and on rows that it left out.
pub fn notes(data: &Data, diagnosis: &Diagnosis) -> Vec<String> {
    let (used, all) = (diagnosis.rows, data.len());
    let some = (used < all).then(|| format!("{used} of {all} rows were used, evenly chosen"));
    data.notes_of_fit().into_iter().chain(some).collect()
}
