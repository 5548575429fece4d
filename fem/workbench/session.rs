//! A session: what is open, what was done, and what can be undone.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::bench::{Bench, Corrected, Remedied};
use super::disk::Disk;
use super::folder::Folder;
use super::job::Job;
use super::kept::Kept;
use super::refusal::Refusal;
use super::steps::Steps;
use super::told;
use crate::model::{Draft, Model};
use crate::process::Coordinate;

/// What is open on the page.
pub struct Session {
    pub(super) folder: Folder,
    pub(super) now: Bench,
    pub(super) steps: Steps,
    pub(super) version: u64,
    /// What the files have that were opened or written.
    pub(super) disk: Disk,
    /// What is wrong with a file that was changed elsewhere; what was open stays.
    pub(super) trouble: Option<String>,
    pub(super) job: Option<Job>,
    pub(super) kept: Kept,
}

impl Session {
    /// Opens a folder, or a model in one.
    ///
    /// # Errors
    /// There is no such folder; the model is wrong.
    pub fn open(path: &Path) -> Result<Self, Refusal> {
        let (folder, model) = match path.is_dir() {
            true => (path, None),
            false => {
                let above = path.parent().filter(|above| !above.as_os_str().is_empty()).unwrap_or(Path::new("."));
                (above, path.file_name().and_then(|name| name.to_str()))
            }
        };
        let folder = Folder::open(folder)?;
        let mut own = Self {
            kept: Kept::of(folder.path()),
            folder,
            now: Bench::default(),
            steps: Steps::default(),
            version: 1,
            disk: Disk::default(),
            trouble: None,
            job: None,
        };
        if let Some(name) = model {
            own.open_model(name)?;
        }
        Ok(own)
    }

    /// The port at which it is served: another program that finds what it keeps knows by that that it runs.
    pub fn served_at(&mut self, port: u16) {
        self.kept.port = port;
    }

    /// Number of the state: another one is another number.
    pub fn version(&self) -> u64 {
        self.version
    }

    /// The work that runs.
    pub fn job(&self) -> Option<&Job> {
        self.job.as_ref()
    }

    /// Everything that the page shows.
    pub fn state(&self) -> Json {
        let listing = self.folder.listing();
        let text = self.now.model.as_ref().map(Model::text);
        let is_of = |of: &str| text.as_deref() == Some(of);
        let noise = self.now.compared.as_ref().and_then(|found| found.as_ref().ok()).map(|found| found.noise);
        let correction = |own: &Arc<Corrected>| json!({ "is_current": is_of(&own.of), "html": own.html });
        let remedies = |own: &Arc<Remedied>| json!({ "is_current": is_of(&own.of), "html": own.html });
        json!({
            "version": self.version,
            "folder": self.folder.path().display().to_string(),
            "models": listing.models,
            "measurements": listing.measurements,
            "programs": listing.programs,
            "model": told::model(&self.now, text.as_deref().unwrap_or_default(), self.is_saved()),
            "trouble": self.trouble,
            "data": told::data(&self.now),
            "comparison": told::comparison(self.now.compared.as_ref()),
            "steps": self.now.steps.iter().map(|(label, rms)| json!({ "label": label, "rms": rms })).collect::<Vec<_>>(),
            "noise": noise,
            "diagnosis": self.now.diagnosed.as_ref().map(|own| told::diagnosis(own, self.now.model.as_ref(), is_of(&own.of))),
            "tolerance": self.now.standing,
            "correction": self.now.corrected.as_ref().map(correction),
            "remedies": self.now.remedied.as_ref().map(remedies),
            "session": self.last_session().map(|steps| json!({ "steps": steps })),
            "undo": self.steps.to_undo(),
            "redo": self.steps.to_redo(),
            "history": self.steps.commands().collect::<Vec<_>>(),
            "job": self.job.as_ref().map(Job::json),
        })
    }

    /// The rows with what is predicted of them.
    ///
    /// # Errors
    /// No model is open, or nothing was measured.
    pub fn rows(&self) -> Result<Json, Refusal> {
        let none = || Refusal::new("there is nothing to show", "open a model and a file of measurements");
        told::rows(&self.now, self.version).ok_or_else(none)
    }

    pub(super) fn is_saved(&self) -> bool {
        self.now.model.as_ref().is_none_or(|model| self.disk.has(&self.now.file, &model.text()))
    }

    pub(super) fn model(&self) -> Result<&Model, Refusal> {
        self.now.model.as_ref().ok_or_else(|| Refusal::new("no model is open", "open one of this folder"))
    }

    /// Takes a step that can be undone.
    pub(super) fn step(&mut self, label: impl Into<String>, command: Option<String>, next: Bench) {
        self.steps.take(&mut self.now, next, (label.into(), command));
        self.version += 1;
    }

    /// Opens a model of the folder.
    ///
    /// # Errors
    /// It is none, or it is wrong.
    pub fn open_model(&mut self, name: &str) -> Result<(), Refusal> {
        let model = self.read_model(name)?;
        self.disk.note(name, model.source.text.to_string());
        let file = name.to_string();
        let mut next = Bench { by_commands: file.clone(), file, model: Some(model), ..Bench::default() };
        if let Some(measured) = self.now.measured.clone() {
            let same = |own: &Model| self.now.model.as_ref().is_some_and(|m| m.process.name() == own.process.name());
            if next.model.as_ref().is_some_and(same) {
                (next.measured, next.files) = (Some(measured), self.now.files.clone());
                (next.struck, next.reading) = (self.now.struck.clone(), self.now.reading.clone());
            }
        }
        next.compare();
        next.note(name.to_string());
        self.trouble = None;
        self.step(format!("open {name}"), None, next);
        Ok(())
    }

    pub(super) fn read_model(&self, name: &str) -> Result<Model, Refusal> {
        let recorded = self.now.measured.as_ref().map_or(&[][..], |own| &own.recorded);
        let draft = Draft::load(&self.folder.file(name)?)?;
        let same = self.now.model.as_ref().is_some_and(|own| own.process.name() == draft.process().name());
        self.admitted(draft, if same { recorded } else { &[] })
    }

    /// The model of a draft that reads nothing from elsewhere.
    ///
    /// # Errors
    /// It does, or it is wrong.
    pub(super) fn admitted(&self, draft: Draft, recorded: &[Coordinate]) -> Result<Model, Refusal> {
        draft.texts().into_iter().try_for_each(|text| self.folder.keeps(&text))?;
        let model = draft.with(recorded)?;
        self.folder.holds(&model)?;
        Ok(model)
    }

    /// Takes the last step back.
    ///
    /// # Errors
    /// There is none.
    pub fn undo(&mut self) -> Result<(), Refusal> {
        self.steps.undo(&mut self.now).ok_or_else(|| Refusal::new("there is nothing to undo", "take a step first"))?;
        self.version += 1;
        Ok(())
    }

    /// Takes again the step that was taken back.
    ///
    /// # Errors
    /// There is none.
    pub fn redo(&mut self) -> Result<(), Refusal> {
        self.steps.redo(&mut self.now).ok_or_else(|| Refusal::new("there is nothing to redo", "undo a step first"))?;
        self.version += 1;
        Ok(())
    }

    /// Writes the model into its file, or under another name.
    ///
    /// # Errors
    /// It cannot be written; a file of another name is there.
    pub fn save(&mut self, name: Option<&str>) -> Result<String, Refusal> {
        let own = self.now.file.clone();
        let name = name.unwrap_or(&own).to_string();
        if name == own {
            self.disk.check(self.folder.path(), &own)?;
        }
        let model = self.model()?;
        let text = model.text_at(&self.folder.path().join(&name));
        self.folder.write(&name, text.as_bytes(), name == own)?;
        self.disk.note(&name, text);
        self.now.file.clone_from(&name);
        self.trouble = None;
        self.version += 1;
        Ok(name)
    }
}
