//! A session: what is open, what was done, and what can be undone.

use std::path::Path;
use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::bench::Bench;
use super::folder::Folder;
use super::job::{Job, Material, Outcome, Work};
use super::refusal::Refusal;
use super::steps::Steps;
use super::told;
use crate::ask::{mended, revised};
use crate::input::{Stamp, stamp};
use crate::measure::{Measurements, Reading};
use crate::model::{Draft, Entry, Model, Setting, add_effect};
use crate::output::{add_command, quoted, set_command};

/// What is open on the page.
pub struct Session {
    pub(super) folder: Folder,
    pub(super) now: Bench,
    pub(super) steps: Steps,
    version: u64,
    /// Text of the model as its file has it, and the stamp of the file when that was looked at.
    saved: String,
    stamp: Option<Stamp>,
    /// What is wrong with a file that was changed elsewhere; what was open stays.
    trouble: Option<String>,
    job: Option<Job>,
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
        let mut own = Self {
            folder: Folder::open(folder)?,
            now: Bench::default(),
            steps: Steps::default(),
            version: 1,
            saved: String::new(),
            stamp: None,
            trouble: None,
            job: None,
        };
        if let Some(name) = model {
            own.open_model(name)?;
        }
        Ok(own)
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
        let (models, measurements) = self.folder.listing();
        let text = self.now.model.as_ref().map(Model::text);
        let is_of = |of: &str| text.as_deref() == Some(of);
        let noise = self.now.compared.as_ref().and_then(|found| found.as_ref().ok()).map(|found| found.noise);
        let correction =
            self.now.corrected.as_ref().map(|own| json!({ "is_current": is_of(&own.of), "html": own.html }));
        json!({
            "version": self.version,
            "folder": self.folder.path().display().to_string(),
            "models": models,
            "measurements": measurements,
            "model": told::model(&self.now, text.as_deref().unwrap_or_default(), is_of(&self.saved)),
            "trouble": self.trouble,
            "data": told::data(&self.now),
            "comparison": told::comparison(self.now.compared.as_ref()),
            "steps": self.now.steps.iter().map(|(label, rms)| json!({ "label": label, "rms": rms })).collect::<Vec<_>>(),
            "noise": noise,
            "diagnosis": self.now.diagnosed.as_ref().map(|own| told::diagnosis(own, self.now.model.as_ref(), is_of(&own.of))),
            "correction": correction,
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

    fn is_saved(&self) -> bool {
        self.now.model.as_ref().is_none_or(|model| model.text() == self.saved)
    }

    pub(super) fn model(&self) -> Result<&Model, Refusal> {
        self.now.model.as_ref().ok_or_else(|| Refusal::new("no model is open", "open one of this folder"))
    }

    /// Takes a step that can be undone.
    fn step(&mut self, label: impl Into<String>, command: Option<String>, next: Bench) {
        self.steps.take(&mut self.now, next, (label.into(), command));
        self.version += 1;
    }

    /// Opens a model of the folder.
    ///
    /// # Errors
    /// It is none, or it is wrong.
    pub fn open_model(&mut self, name: &str) -> Result<(), Refusal> {
        let model = self.read_model(name)?;
        self.saved = model.source.text.to_string();
        let file = name.to_string();
        let mut next = Bench { by_commands: file.clone(), file, model: Some(model), ..Bench::default() };
        if let Some(measured) = self.now.measured.clone() {
            let same = |own: &Model| self.now.model.as_ref().is_some_and(|m| m.process.name() == own.process.name());
            if next.model.as_ref().is_some_and(same) {
                (next.measured, next.files, next.struck) =
                    (Some(measured), self.now.files.clone(), self.now.struck.clone());
            }
        }
        next.compare();
        next.note(name.to_string());
        self.trouble = None;
        self.step(format!("open {name}"), None, next);
        Ok(())
    }

    fn read_model(&self, name: &str) -> Result<Model, Refusal> {
        let recorded = self.now.measured.as_ref().map_or(&[][..], |own| &own.recorded);
        let draft = Draft::load(&self.folder.file(name)?)?;
        draft.texts().into_iter().try_for_each(|text| self.folder.keeps(&text))?;
        let same = self.now.model.as_ref().is_some_and(|own| own.process.name() == draft.process().name());
        let model = draft.with(if same { recorded } else { &[] })?;
        self.folder.holds(&model)?;
        Ok(model)
    }

    /// Opens files of measurements of the folder.
    ///
    /// # Errors
    /// They are none, or do not fit the model.
    pub fn open_data(&mut self, names: &[String]) -> Result<(), Refusal> {
        let mut next = self.now.clone();
        let Some(model) = &next.model else {
            return Err(Refusal::new("no model is open", "open the model first: it says what its measurements are"));
        };
        next.struck.clear();
        next.files = names.to_vec();
        (next.measured, next.diagnosed) = (None, None);
        if !names.is_empty() {
            let paths = names.iter().map(|name| self.folder.file(name)).collect::<Result<Vec<_>, Refusal>>()?;
            let read = Measurements::load_all(&paths, &*model.process, &Reading::default(), false)?;
            let model = model.with_recorded(&read.recorded)?;
            // What lies off the model is told now.
            let measured = Arc::new(read);
            Bench::data(&model, (*measured).clone(), &Arc::default())?;
            (next.model, next.measured) = (Some(model), Some(measured));
        }
        next.steps.clear();
        next.compare();
        next.note(next.file.clone());
        let command = (!names.is_empty()).then(|| {
            let with: Vec<String> = names.iter().map(|name| format!("--with {}", quoted(name))).collect();
            format!("fem compare {} {}", quoted(&next.by_commands), with.join(" "))
        });
        self.step("open measurements", command, next);
        Ok(())
    }

    /// Stores a file that was dropped on the page, under a name that nothing has yet.
    ///
    /// # Errors
    /// It is no name of a file here, or it cannot be written.
    pub fn store(&mut self, name: &str, bytes: &[u8]) -> Result<String, Refusal> {
        let (stem, ending) = name.rsplit_once('.').unwrap_or((name, "csv"));
        let free = self.folder.free(stem, ending);
        self.folder.write(&free, bytes, false)?;
        self.version += 1;
        Ok(free)
    }

    /// Puts another model in the place of the one that is open, `by` a command that writes a file.
    fn change(&mut self, label: String, by: Option<(String, String)>, model: Model, is_told: bool) {
        let mut next = Bench { model: Some(model), ..self.now.clone() };
        let command = by.map(|(command, to)| {
            next.by_commands = to;
            command
        });
        next.compare();
        if is_told {
            next.note(label.clone());
        }
        self.step(label, command, next);
    }

    /// Writes another value: `450 +- 20 N`, `? N`.
    ///
    /// # Errors
    /// The model would not be right.
    pub fn set(&mut self, path: &str, text: &str) -> Result<(), Refusal> {
        let model = self.model()?;
        self.folder.keeps(text)?;
        let setting = Setting { key: path.to_string(), value: Entry::Text(text.to_string()) };
        let next =
            revised(model, std::slice::from_ref(&setting), &[]).map_err(|problem| Refusal::from(problem).at(path))?;
        self.folder.holds(&next)?;
        let command = set_command(&self.now.by_commands, &setting);
        self.change(format!("{path} = {text}"), Some(command), next, false);
        Ok(())
    }

    /// Adds an effect: with the values of the last diagnosis where that found it, with unknown ones else.
    ///
    /// # Errors
    /// It is none of this process, it is there, or it cannot act in this model.
    pub fn add(&mut self, effect: &str) -> Result<(), Refusal> {
        let model = self.model()?;
        let found = self.now.diagnosed.as_ref().and_then(|own| {
            let place = own.json["missing"].as_array()?.iter().position(|cause| cause["effect"] == effect)?;
            own.additions.get(place)
        });
        let (next, command) = match found {
            Some(addition) => (mended(model, addition)?, addition.command(&self.now.by_commands)),
            None => (add_effect(model, effect, &[])?, add_command(&self.now.by_commands, effect, &[])),
        };
        self.change(format!("+ {effect}"), Some(command), next, true);
        Ok(())
    }

    /// Leaves an effect out.
    ///
    /// # Errors
    /// The model has none of the name.
    pub fn remove(&mut self, effect: &str) -> Result<(), Refusal> {
        let next = revised(self.model()?, &[], &[effect.to_string()])?;
        let command = crate::output::leave_out_command(&self.now.by_commands, effect);
        self.change(format!("- {effect}"), Some(command), next, true);
        Ok(())
    }

    /// Strikes rows out by hand, or takes them in again.
    ///
    /// # Errors
    /// There is no such row, or none would be left.
    pub fn strike(&mut self, rows: &[usize], is_struck: bool) -> Result<(), Refusal> {
        let count = self.now.measured.as_ref().map_or(0, |own| own.len());
        if rows.iter().any(|row| *row >= count) {
            return Err(Refusal::new("there is no such row", "name rows of the measurements, from 0"));
        }
        let mut next = self.now.clone();
        for row in rows {
            if is_struck {
                next.struck.insert(*row)
            } else {
                next.struck.remove(row)
            };
        }
        if next.struck.len() == count {
            return Err(Refusal::new("no row would be left", "leave some of them in"));
        }
        next.diagnosed = None;
        next.compare();
        let label = if is_struck { "strike rows out" } else { "take rows in again" };
        self.step(label, None, next);
        Ok(())
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

    /// Begins work beside the page: what it needs comes back, to be done on a thread of its own.
    ///
    /// # Errors
    /// Other work runs, or nothing is open.
    pub fn begin(&mut self, work: Work) -> Result<(Job, Material), Refusal> {
        if let Some(job) = &self.job {
            let doing = job.work.word();
            return Err(Refusal::new(format!("{doing} runs already"), "wait until it has ended, or stop it"));
        }
        let material = Material { model: self.model()?.clone(), measured: self.now.counted() };
        if work != Work::Correct && material.measured.is_none() {
            return Err(Refusal::new("nothing was measured", "open a file of measurements"));
        }
        let job = Job::new(work, material.model.text());
        (self.job, self.trouble) = (Some(job.clone()), None);
        self.version += 1;
        Ok((job, material))
    }

    /// Stops the work that runs.
    ///
    /// # Errors
    /// None runs.
    pub fn stop(&mut self) -> Result<(), Refusal> {
        let job = self.job.as_ref().ok_or_else(|| Refusal::new("nothing runs", "there is nothing to stop"))?;
        job.progress.stop();
        Ok(())
    }

    /// Takes what came of work; nothing of what was stopped.
    pub fn end(&mut self, outcome: Result<Outcome, Refusal>) {
        let Some(job) = self.job.take() else { return };
        self.version += 1;
        if job.progress.is_stopped() {
            return;
        }
        let with: Vec<String> = self.now.files.iter().map(|name| format!("--with {}", quoted(name))).collect();
        let (file, with) = (quoted(&self.now.by_commands), with.join(" "));
        match outcome {
            Ok(Outcome::Diagnosed(found)) => {
                let next = Bench { diagnosed: Some(Arc::new(found)), ..self.now.clone() };
                self.step("diagnose", Some(format!("fem diagnose {file} {with}")), next);
            }
            // What was done meanwhile is not taken back by what was found for the model before it.
            Ok(Outcome::Fitted(_)) if self.now.model.as_ref().is_none_or(|model| model.text() != job.of) => {
                self.trouble = Some("the model was changed while it was fitted: fit it again".into());
            }
            Ok(Outcome::Fitted(model)) => {
                let stem = self.now.by_commands.strip_suffix(".toml").unwrap_or(&self.now.by_commands);
                let to = format!("{stem}-fitted.toml");
                let command = format!("fem fit {file} {with} --add-to {}", quoted(&to));
                self.change("fit".into(), Some((command, to)), *model, true);
            }
            Ok(Outcome::Corrected(found)) => {
                let next = Bench { corrected: Some(Arc::new(found)), ..self.now.clone() };
                self.step("correct", Some(format!("fem correct {file}")), next);
            }
            Err(refusal) => self.trouble = Some(refusal.text()),
        }
    }

    /// Writes the model into its file, or under another name.
    ///
    /// # Errors
    /// It cannot be written; a file of another name is there.
    pub fn save(&mut self, name: Option<&str>) -> Result<String, Refusal> {
        let own = self.now.file.clone();
        let name = name.unwrap_or(&own).to_string();
        let model = self.model()?;
        let text = model.text_at(&self.folder.path().join(&name));
        self.folder.write(&name, text.as_bytes(), name == own)?;
        (self.now.file, self.saved) = (name.clone(), text);
        self.version += 1;
        Ok(name)
    }

    /// Looks whether the file of the model was changed elsewhere: the page follows, and a wrong file keeps what was.
    pub fn look(&mut self) {
        let Some(path) = self.now.model.as_ref().and_then(|_| self.folder.file(&self.now.file).ok()) else { return };
        let now = stamp(&path);
        if now == self.stamp || !self.is_saved() {
            return;
        }
        self.stamp = now;
        let text = std::fs::read_to_string(path).unwrap_or_default();
        if text.is_empty() {
            return;
        }
        if text == self.saved {
            // Mended again.
            self.version += u64::from(self.trouble.take().is_some());
            return;
        }
        let name = self.now.file.clone();
        match self.read_model(&name) {
            Ok(model) => {
                self.saved = text;
                self.trouble = None;
                self.change(format!("{name} was changed elsewhere"), None, model, true);
            }
            Err(refusal) => {
                let told = format!("{name} is wrong now, and what was open stays: {}", refusal.text());
                if self.trouble.as_ref() != Some(&told) {
                    self.trouble = Some(told);
                    self.version += 1;
                }
            }
        }
    }

    /// Stores rows that were measured, as a file of measurements beside those that are open.
    ///
    /// # Errors
    /// They are no measurements of the model.
    pub fn readings(&mut self, csv: &str) -> Result<(), Refusal> {
        let name = self.folder.free("readings", "csv");
        let path = self.folder.write(&name, csv.as_bytes(), false)?;
        let mut files = self.now.files.clone();
        files.push(name);
        self.open_data(&files).inspect_err(|_| {
            // It was ours, and holds nothing that the page has not.
            let _ = std::fs::remove_file(&path);
        })
    }
}
