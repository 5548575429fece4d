//! The answer of `fem correct`, whatever there is to do.

use serde_json::Value as Json;

use super::OutputError;
use super::advised::AdvisedAnswer;
use super::answer::Answer;
use super::block::Block;
use super::chart::Svg;
use super::correction::CorrectionAnswer;
use super::staged::Staged;
use crate::correct::Action;
use crate::model::Model;
use crate::process::Table;

/// What to do about a model: another command, or what to change.
pub struct ActionAnswer<'a>(pub &'a Model, pub &'a Action);

impl ActionAnswer<'_> {
    fn told<T>(&self, of: impl FnOnce(&dyn Answer) -> T) -> T {
        let Self(model, found) = *self;
        match found {
            Action::Command(found, programmed) => of(&CorrectionAnswer(model, found, programmed.as_deref())),
            Action::Advice(found) => of(&AdvisedAnswer(model, found)),
        }
    }

    /// The change at every place of every part, what is left there, and its interval; no columns where no command is
    /// corrected.
    pub fn table(&self) -> Table {
        let Self(model, found) = *self;
        match found {
            Action::Command(found, programmed) => CorrectionAnswer(model, found, programmed.as_deref()).table(),
            Action::Advice(_) => Table { columns: Vec::new() },
        }
    }
}

impl Answer for ActionAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        self.told(|own| own.blocks())
    }

    fn json(&self) -> Json {
        self.told(|own| own.json())
    }

    fn figures(&self) -> Vec<(String, Svg)> {
        self.told(|own| own.figures())
    }

    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        self.told(|own| own.stage(files))
    }
}
