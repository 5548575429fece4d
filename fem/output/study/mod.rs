//! A study: its rows as they grow, and what they say.

mod folder;
mod json;
mod layout;
mod merge;
mod own;
pub mod parquet;
mod rows;
mod sums;
mod text;

pub use folder::{Earlier, StudyError, StudyFolder};
pub use merge::merge;
pub use rows::line;

/// Names of files that a study keeps beside its rows.
pub(crate) const OWN: [&str; 2] = [layout::FILE, sums::FILE];

use serde_json::Value;

use super::OutputError;
use super::answer::Answer;
use super::block::Block;
use super::json::json as document;
use super::staged::Staged;
use crate::study::{Layout, Summary};

/// The rows of a study, and what they say; `Study::answer` makes one.
pub struct StudyAnswer<'a>(#[doc(hidden)] pub &'a Layout, #[doc(hidden)] pub &'a Summary);

impl Answer for StudyAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        vec![Block::Lines(text::text(self.0, self.1))]
    }

    fn json(&self) -> Value {
        json::json(self.0, self.1)
    }

    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        files.text("study.json", &document(self))
    }
}
