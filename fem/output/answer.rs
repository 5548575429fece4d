//! Answers of the commands: everything that one has to say, before it becomes text, JSON, figures or a folder.

use serde_json::Value;

use super::OutputError;
use super::block::Block;
use super::chart::Svg;
use super::staged::Staged;
use crate::progress::Progress;

/// Answer of a command, for [`text`](fn@super::text), [`json`](fn@super::json), [`figures`] and a
/// [`Folder`](super::Folder). The answers of the program implement it, and nobody else can.
pub trait Answer {
    /// The answer for people, from top to bottom.
    #[doc(hidden)]
    fn blocks(&self) -> Vec<Block>;

    /// The answer for programs. No NaN, no infinity: what is unknown is null.
    #[doc(hidden)]
    fn json(&self) -> Value;

    /// Figures, each with the stem of its file.
    #[doc(hidden)]
    fn figures(&self) -> Vec<(String, Svg)> {
        Vec::new()
    }

    /// Progress of a computation whose time may be limited.
    #[doc(hidden)]
    fn progress(&self) -> Option<&Progress> {
        None
    }

    /// Writes the files of its folder, if it has more than figures.
    ///
    /// # Errors
    /// A file cannot be written.
    #[doc(hidden)]
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        files.figures(self.figures())
    }
}

/// The figures of an answer as texts of SVG files, each with the stem of its name.
pub fn figures(answer: &dyn Answer) -> Vec<(String, String)> {
    answer.figures().into_iter().map(|(name, svg)| (name, svg.file())).collect()
}

/// Steps left undone for want of time, the first few by name and the number of the others.
pub(super) fn left_undone(progress: Option<&Progress>) -> Vec<String> {
    /// Most that are named.
    const MOST: usize = 12;
    let mut all = progress.map_or(Vec::new(), Progress::left_undone);
    all.sort_unstable();
    let more = all.len().saturating_sub(MOST);
    all.truncate(MOST);
    all.extend((more > 0).then(|| format!("{more} more")));
    all
}
