//! Models that a search has written.

use std::path::Path;

use super::error::Error;
use super::say::say;
use super::terminal::notes;
use crate::ask::usual_said;
use crate::fit::Estimate;
use crate::model::Model;
use crate::output::files::{self, Guard};

/// Writes a model that was made of another one, and says so.
pub fn write_model(new: &Path, model: &Model, before: &Model, guard: Guard) -> Result<(), Error> {
    files::write(new, model.text_at(new).as_bytes(), guard)?;
    say!("written {}", new.display());
    notes(&usual_said(model, before));
    Ok(())
}

/// Notes of which values the model has what it had.
pub fn note_open<'e>(open: impl Iterator<Item = &'e Estimate>) {
    for own in open {
        say!("note: {} stays as it was: the data leave its interval open", own.parameter.path);
    }
}
