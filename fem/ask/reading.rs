//! Models together with what was measured for them.

use std::path::Path;

use super::refuse_mixed;
use crate::input::InputError;
use crate::measure::Measurements;
use crate::model::{Draft, Model};
use crate::process::Process;

/// Reads a model and what was measured for it: columns that the measurements record beside those of the process are
/// coordinates of the model.
///
/// # Errors
/// The model is wrong, or the measurements are.
pub fn read<E: From<InputError>>(
    path: &Path,
    measured: impl FnOnce(&dyn Process) -> Result<Measurements, E>,
) -> Result<(Model, Measurements), E> {
    let draft = Draft::load(path)?;
    let measured = measured(draft.process())?;
    Ok((draft.with(&measured.recorded)?, measured))
}

/// The same for several models of one process; none where there is no model.
///
/// # Errors
/// A model is wrong, the measurements are, or the models are of several processes.
pub fn read_all<P: AsRef<Path>, E: From<InputError> + From<super::Error>>(
    paths: &[P],
    measured: impl FnOnce(&dyn Process) -> Result<Measurements, E>,
) -> Result<Option<(Vec<Model>, Measurements)>, E> {
    let drafts: Vec<Draft> = paths.iter().map(|path| Draft::load(path.as_ref())).collect::<Result<_, InputError>>()?;
    let Some(first) = drafts.first().map(Draft::process) else { return Ok(None) };
    if drafts.iter().any(|draft| draft.process().name() != first.name()) {
        let models: Vec<Model> = drafts.into_iter().map(|draft| draft.with(&[])).collect::<Result<_, InputError>>()?;
        refuse_mixed(&models)?;
        return Ok(None);
    }
    let measured = measured(first)?;
    let models = drafts.into_iter().map(|draft| draft.with(&measured.recorded)).collect::<Result<_, InputError>>()?;
    Ok(Some((models, measured)))
}
