//! What to change where no command is corrected place by place.

use crate::knowledge::{Band, Knowledge};
use crate::model::Model;
use crate::process::{Advice, Failure, Rows, Standing};
use crate::progress::Progress;

/// What to change, and what is made as it is. SI.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Advised {
    /// The rows of the model's programme.
    pub rows: Rows,
    /// What the machine makes of each, as an error.
    pub values: Vec<f64>,
    /// How far that may be off, and the probability that it is within what is asked.
    pub band: Band,
    /// How it stands against the drawing.
    pub standings: Vec<Standing>,
    /// What to change.
    pub advice: Vec<Advice>,
}

/// What a process knows to change at a model whose values are known.
///
/// # Errors
/// The model cannot be computed.
pub fn advise(model: &Model, progress: &Progress) -> Result<Advised, Failure> {
    let knowledge = Knowledge::of(model);
    let rows = model.open_programme();
    let nothing = std::sync::Arc::default();
    let best = model.commanded_at(&knowledge.values, &nothing)?;
    let values = progress.stretch("as it is", || best.observe(&rows))?;
    let band = progress.stretch("what is known of it", || Band::about(model, &rows, &values))?;
    let told = model.system.resolved(&rows);
    let standings = Standing::all(&*model.system, &told, &values);
    let advice = progress.stretch("what to change", || best.advice(&told, &values))?;
    Ok(Advised { rows: told, values, band, standings, advice })
}
