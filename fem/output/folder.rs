//! Answers as files in a folder: tables, figures, shapes for ParaView, JSON.

use std::path::Path;

use super::OutputError;
use super::answer::Answer;
use super::files::{Account, Guard, Stage};
use super::staged::Staged;
use crate::progress::Progress;

/// A folder in which the files of an answer appear all together or not at all.
pub struct Folder<'a> {
    /// Where they appear; made if it is missing.
    pub directory: &'a Path,
    /// Rule by which files there may be replaced.
    pub guard: Guard<'a>,
}

impl Folder<'_> {
    /// Writes the files of the answer of a command, and lists those that a user opens.
    ///
    /// # Errors
    /// A file cannot be written, or may not be replaced.
    pub fn write(
        &self,
        command: &'static str,
        answer: &dyn Answer,
        progress: &Progress,
    ) -> Result<String, OutputError> {
        self.staged(command, progress, |files| answer.stage(files))
    }

    /// Writes the figures of an answer alone, and lists them.
    ///
    /// # Errors
    /// As those of [`write`](Self::write).
    pub fn write_figures(&self, answer: &dyn Answer) -> Result<String, OutputError> {
        self.staged("plot", &Progress::default(), |files| files.figures(answer.figures()))
    }

    fn staged(
        &self,
        command: &'static str,
        progress: &Progress,
        write: impl FnOnce(&mut Staged) -> Result<(), OutputError>,
    ) -> Result<String, OutputError> {
        let mut files = Staged::new(Stage::new(self.directory, command, self.guard)?, progress);
        write(&mut files)?;
        let list = files.publish()?.into_iter().map(|name| format!("\n  {}", self.directory.join(name).display()));
        // Results that nothing proves to be the program's own are not replaced by the next run.
        let unknown = Account::unusable().map_or(String::new(), |reason| {
            format!("\nnote: {reason}: the next run will not know these files as its own, and asks for --force\n")
        });
        Ok(format!("\nwritten{}\n{unknown}", list.collect::<String>()))
    }
}
