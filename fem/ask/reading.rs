//! Models together with what was measured for them.

use std::path::Path;

use super::refuse_mixed;
use crate::input::{InputError, Problem};
use crate::measure::{Measurements, Reading};
use crate::model::{Draft, Model};
use crate::process::Process;

/// Reads a model and what was measured for it: columns that the measurements record beside those of the process are
/// coordinates of the model. `measured` gets the process and how the model's files are read.
///
/// # Errors
/// The model is wrong, or the measurements are.
pub fn read<E: From<InputError>>(
    path: &Path,
    measured: impl FnOnce(&dyn Process, &Reading) -> Result<Measurements, E>,
) -> Result<(Model, Measurements), E> {
    let draft = Draft::load(path)?;
    let measured = measured(draft.process(), &draft.reading()?)?;
    Ok((draft.with(&measured.recorded)?, measured))
}

/// The same for several models of one process; none where there is no model.
///
/// # Errors
/// A model is wrong, the measurements are, or the models are of several processes.
pub fn read_all<P: AsRef<Path>, E: From<InputError> + From<super::Error>>(
    paths: &[P],
    measured: impl FnOnce(&dyn Process, &Reading) -> Result<Measurements, E>,
) -> Result<Option<(Vec<Model>, Measurements)>, E> {
    let drafts: Vec<Draft> = paths.iter().map(|path| Draft::load(path.as_ref())).collect::<Result<_, InputError>>()?;
    let Some(first) = drafts.first().map(Draft::process) else { return Ok(None) };
    if drafts.iter().any(|draft| draft.process().name() != first.name()) {
        let models: Vec<Model> = drafts.into_iter().map(|draft| draft.with(&[])).collect::<Result<_, InputError>>()?;
        refuse_mixed(&models)?;
        return Ok(None);
    }
    let measured = measured(first, &reading(&drafts)?)?;
    let models = drafts.into_iter().map(|draft| draft.with(&measured.recorded)).collect::<Result<_, InputError>>()?;
    Ok(Some((models, measured)))
}

/// How the files of several models are read: as one of them says, and no other says otherwise.
fn reading(drafts: &[Draft]) -> Result<Reading, super::Error> {
    let mut all = Vec::new();
    for draft in drafts {
        let reading = draft.reading()?;
        if !reading.says_nothing() {
            all.push((draft.name(), reading));
        }
    }
    match &all[..] {
        [] => Ok(Reading::default()),
        [(_, first), rest @ ..] => match rest.iter().find(|(_, other)| other != first) {
            None => Ok(first.clone()),
            Some((name, _)) => {
                let message = format!("[data] of {name} says otherwise than that of {}", all[0].0);
                let help = "their measurements are one file, which is read in one way: let both say the same";
                Err(Problem::new(message).help(help).into())
            }
        },
    }
}
