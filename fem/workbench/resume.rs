//! A session keeps what is not saved, so that it is not lost when the program ends, and the next one goes on there.

use std::path::PathBuf;
use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::bench::Bench;
use super::refusal::Refusal;
use super::session::Session;
use super::told;
use crate::input::{Source, text_of};
use crate::measure::Measurements;
use crate::model::Draft;

impl Session {
    /// Keeps what is not saved, where something has changed; what was saved need not be kept.
    pub fn keep(&mut self) {
        if self.kept.version == self.version {
            return;
        }
        self.kept.version = self.version;
        if self.is_saved() {
            return self.kept.clear();
        }
        let Some(model) = &self.now.model else { return };
        let reading = &self.now.reading;
        let told = json!({
            "file": self.now.file,
            "text": model.text(),
            "files": self.now.files,
            "reading": told::reading(reading),
            "struck": self.now.struck.iter().collect::<Vec<_>>(),
            "history": self.steps.commands().collect::<Vec<_>>(),
            "by_commands": self.now.by_commands,
            "steps": self.steps.count(),
        });
        self.kept.write(&self.folder, told);
    }

    /// Number of steps of the session before that is not taken up yet.
    pub fn last_session(&self) -> Option<u64> {
        self.kept.last.as_ref().and_then(|(_, told)| told["steps"].as_u64())
    }

    fn last(&self) -> Result<(PathBuf, Json), Refusal> {
        self.kept.last.clone().ok_or_else(|| Refusal::new("there is no session to be taken up", "go on with this one"))
    }

    /// Goes on where the session before was.
    ///
    /// # Errors
    /// There is none, or it is none any more: its files have gone.
    pub fn resume(&mut self) -> Result<(), Refusal> {
        let (path, told) = self.last()?;
        let text = |key: &str| told[key].as_str().unwrap_or_default().to_string();
        let list = |key: &str| told[key].as_array().cloned().unwrap_or_default();
        let texts = |key: &str| list(key).iter().filter_map(|own| Some(own.as_str()?.to_string())).collect::<Vec<_>>();
        let file = text("file");
        let own = self.folder.file(&file)?;
        let draft = Draft::parse(Source::new(own.display().to_string(), text("text")))?;
        let reading = Self::reading(&told["reading"])?;
        let files = texts("files");
        // The model is worth more than what it was compared with, which may have gone.
        let (measured, files, lost) = match files.is_empty() {
            true => (None, files, None),
            false => match self.load(&files, draft.process(), &reading) {
                Ok(measured) => (Some(measured), files, None),
                Err(refusal) => (None, Vec::new(), Some(refusal.text())),
            },
        };
        let model = self.admitted(draft, measured.as_ref().map_or(&[][..], |own| &own.recorded))?;
        let count = measured.as_ref().map_or(0, Measurements::len);
        let struck =
            list("struck").into_iter().filter_map(|own| Some(own.as_u64()? as usize)).filter(|row| *row < count);
        let mut next = Bench {
            struck: struck.collect(),
            model: Some(model),
            measured: measured.map(Arc::new),
            by_commands: text("by_commands"),
            file,
            files,
            reading,
            ..Bench::default()
        };
        next.compare();
        next.note(next.file.clone());
        self.disk.note(&next.file, text_of(&own));
        self.disk.is_other(self.folder.path(), &next.file);
        self.trouble = lost;
        self.step("take up the last session", None, next);
        texts("history").into_iter().for_each(|command| self.steps.also(command));
        // From now on this session keeps it.
        (self.kept.path, self.kept.last) = (Some(path), None);
        self.keep();
        Ok(())
    }

    /// Leaves what the session before had not saved.
    ///
    /// # Errors
    /// There is nothing.
    pub fn forget(&mut self) -> Result<(), Refusal> {
        let (path, _) = self.last()?;
        let _ = std::fs::remove_file(path);
        self.kept.last = None;
        self.version += 1;
        Ok(())
    }
}
